#include "render/passes/occlusion_pass.h"

#include <glad/gl.h>

namespace kerf::render {
namespace {

constexpr float kReach = 0.10F;  // of the body's size
constexpr float kStrength = 0.75F;

}  // namespace

OcclusionPass::OcclusionPass()
    : measure_(gpu::Program::graphics("render/fullscreen.vert", "render/occlusion.frag")),
      blur_(gpu::Program::graphics("render/fullscreen.vert", "render/occlusion_blur.frag")) {}

void OcclusionPass::draw(const Frame& frame, const gpu::Framebuffer& drawn,
                         const gpu::Framebuffer& plain) {
    if (open_.width() != plain.width() || open_.height() != plain.height()) {
        open_ = gpu::Framebuffer(GL_R8, GL_DEPTH_COMPONENT16, plain.width(), plain.height());
    }
    drawn.blitDepthTo(plain);
    glDisable(GL_DEPTH_TEST);
    open_.bind();
    plain.depth().bind(0);
    measure_.use();
    measure_.set("clipToWorld", Eigen::Matrix4f(frame.viewProjection.inverse()));
    measure_.set("viewProjection", frame.viewProjection);
    measure_.set("eye", frame.eye);
    measure_.set("reach", kReach * frame.bodySize);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    drawn.bind();
    open_.color().bind(1);
    blur_.use();
    blur_.set("strength", kStrength);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
}

}  // namespace kerf::render
