#include "render/passes/depth_passes.h"

#include <glad/gl.h>

#include <initializer_list>

#include "shaders/shared/render_bindings.h"

namespace kerf::render {
namespace {

constexpr float kContactFalloff = 0.085f;  // of the body's size
constexpr float kContactBlur = 0.010f;     // distance between taps, of the body's size

void drawTriangles(const BodyView& body) {
    if (body.triangleCount == 0) {
        return;
    }
    body.positions->bindStorage(shared::kBindPositions);
    body.triangles->bindStorage(shared::kBindTriangles);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * body.triangleCount));
}

void drawDepth(const gpu::Program& program, const gpu::Framebuffer& map,
               const Eigen::Matrix4f& matrix, const Frame& frame, const BodyView& body,
               const BodyView& others) {
    map.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    // What lies outside the depth range is flattened onto it: it still casts its shadow.
    glEnable(GL_DEPTH_CLAMP);
    glClear(GL_DEPTH_BUFFER_BIT);
    program.use();
    program.set("lightMatrix", matrix);
    bindLooks(program, frame);
    drawTriangles(body);
    bindNoLooks(program, frame);
    drawTriangles(others);
    glDisable(GL_DEPTH_CLAMP);
}

void drawFullscreen(const gpu::Framebuffer& target) {
    target.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

ShadowPass::ShadowPass(int size)
    : program_(gpu::Program::graphics("render/shadow.vert", "render/depth_only.frag")),
      map_(0, GL_DEPTH_COMPONENT32F, size, size) {
    glTextureParameteri(map_.depth().id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(map_.depth().id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void ShadowPass::draw(const SceneView& scene, const BodyView& others, const Frame& frame) {
    drawDepth(program_, map_, frame.lightMatrix, frame, scene.body, others);
}

void ShadowPass::bind() const {
    map_.depth().bind(shared::kUnitShadow);
}

FloorShadePass::FloorShadePass(int size)
    : depthProgram_(gpu::Program::graphics("render/shadow.vert", "render/depth_only.frag")),
      shadeProgram_(gpu::Program::graphics("render/fullscreen.vert", "render/floor_shade.frag")),
      blurProgram_(gpu::Program::graphics("render/fullscreen.vert", "render/floor_blur.frag")),
      fromBelow_(0, GL_DEPTH_COMPONENT32F, size, size),
      alongKey_(0, GL_DEPTH_COMPONENT32F, size, size),
      shade_(GL_RG16F, GL_DEPTH_COMPONENT16, size, size),
      scratch_(GL_RG16F, GL_DEPTH_COMPONENT16, size, size) {}

void FloorShadePass::draw(const SceneView& scene, const BodyView& others, const Frame& frame) {
    drawDepth(depthProgram_, fromBelow_, frame.shadeMatrix, frame, scene.body, others);
    drawDepth(depthProgram_, alongKey_, frame.shadeMatrixAlongKey, frame, scene.body, others);
    fromBelow_.depth().bind(0);
    alongKey_.depth().bind(1);
    shadeProgram_.use();
    shadeProgram_.set("depthRange", frame.shadeRange);
    shadeProgram_.set("falloff", kContactFalloff * frame.bodySize);
    drawFullscreen(shade_);
    const float stride = kContactBlur * frame.bodySize / (2 * frame.shadeReach);
    blur(shade_, scratch_, {stride, 0});
    blur(scratch_, shade_, {0, stride});
}

void FloorShadePass::blur(const gpu::Framebuffer& from, const gpu::Framebuffer& to,
                          const Eigen::Vector2f& stride) {
    from.color().bind(0);
    blurProgram_.use();
    blurProgram_.set("stride", stride);
    drawFullscreen(to);
}

void FloorShadePass::bind() const {
    shade_.color().bind(shared::kUnitGround);
}

}  // namespace kerf::render
