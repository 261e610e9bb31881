#include "render/passes/screen_passes.h"

#include <glad/gl.h>

#include "render/passes/surface_pass.h"
#include "shaders/shared/render_bindings.h"
#include "sim/base/math.h"

namespace kerf::render {

namespace {

constexpr float kRimStrength = 0.82F;
constexpr float kWidthShare = 1.0F / 520;  // of the picture's height
constexpr float kLeastWidth = 1.2F;        // [px]

gpu::Program program(const gpu::Defines& defines) {
    return gpu::Program::graphics("render/rim_line.vert", "render/rim_line.frag", defines);
}

constexpr int kSmoothMargin = 4;  // [px]

/// Grows a rectangle in pixels by points of the scene.
class PictureRectangle {
  public:
    explicit PictureRectangle(const Frame& frame) : frame_(frame) {}

    void add(const Vec3& point) {
        const Eigen::Vector4f clip =
            frame_.viewProjection * Vec3f(point.cast<float>()).homogeneous();
        if (clip.w() <= 0) {
            everything_ = true;
            return;
        }
        const Eigen::Vector2f ndc = (clip.head<2>() / clip.w()).cwiseMax(-1.0f).cwiseMin(1.0f);
        low_ = low_.cwiseMin(ndc);
        high_ = high_.cwiseMax(ndc);
    }

    void add(const Bounds& bounds) {
        for (int corner = 0; corner < 8; ++corner) {
            add(bounds.corner(corner));
        }
    }

    void add(const Blade& blade, double margin) {
        for (const Vec3& end : {blade.a, blade.b}) {
            add(widened(Bounds{end, end}, margin));
        }
    }

    /// Sets the scissor; false where there is nothing.
    bool setScissor() const {
        if (everything_) {
            glScissor(0, 0, frame_.width, frame_.height);
            return true;
        }
        const int x0 = pixel(low_.x(), frame_.width) - kSmoothMargin;
        const int y0 = pixel(low_.y(), frame_.height) - kSmoothMargin;
        const int x1 = pixel(high_.x(), frame_.width) + kSmoothMargin;
        const int y1 = pixel(high_.y(), frame_.height) + kSmoothMargin;
        glScissor(std::max(x0, 0), std::max(y0, 0), std::max(x1 - std::max(x0, 0), 0),
                  std::max(y1 - std::max(y0, 0), 0));
        return low_.x() <= high_.x();
    }

  private:
    static int pixel(float ndc, int size) {
        return static_cast<int>(std::lround((0.5 * ndc + 0.5) * size));
    }

    const Frame& frame_;
    Eigen::Vector2f low_ = {2, 2};
    Eigen::Vector2f high_ = {-2, -2};
    bool everything_ = false;
};

PictureRectangle covered(const SceneView& scene, const Frame& frame) {
    PictureRectangle rectangle(frame);
    if (frame.hasBody) {
        rectangle.add(frame.focus);
    }
    if (const std::optional<Blade> blade = drawnBlade(scene, frame.bodySize)) {
        rectangle.add(*blade, bladeHeight(scene, frame.bodySize));
    }
    for (const Blade& pose : scene.strokePoses) {
        rectangle.add(pose, 0);
    }
    return rectangle;
}

constexpr float kReach = 0.10F;  // of the body's size
constexpr float kStrength = 0.75F;

}  // namespace

RimPass::RimPass() : whole_(program({})) {}

const gpu::Program& RimPass::openedOne() {
    if (!opened_) {
        opened_.emplace(program({{"SECTION", "1"}}));
    }
    return *opened_;
}

void RimPass::draw(const SceneView& scene, const Frame& frame, const NormalsPass& shape) {
    const gpu::Program& lines = scene.section ? openedOne() : whole_;
    scene.body.positions->bindStorage(shared::kBindPositions);
    scene.body.triangles->bindStorage(shared::kBindTriangles);
    shape.normals().bindStorage(shared::kBindNormals);
    shape.skinCorners().bindStorage(shared::kBindSkinCorners);
    lines.use();
    bindLooks(lines, frame);
    lines.set("viewProjection", frame.viewProjection);
    lines.set("viewport", Eigen::Vector2f(float(frame.width), float(frame.height)));
    lines.set("width", std::max(kLeastWidth, kWidthShare * float(frame.height)));
    lines.set("strength", kRimStrength);
    lines.set("triangleCount", scene.body.triangleCount);
    lines.set("sidePieces", shape.sidePieces());
    if (scene.section) {
        setSection(lines, scene);
        glEnable(GL_CLIP_DISTANCE0);
    }
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MIN);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, shape.skinCorners().id());
    gpu::beforeDrawingIndirect();
    glDrawArraysIndirect(GL_TRIANGLES, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_CLIP_DISTANCE0);
}

SmoothPass::SmoothPass()
    : program_(gpu::Program::graphics("render/fullscreen.vert", "render/smooth_edges.frag")) {}

void SmoothPass::draw(const SceneView& scene, const Frame& frame, const gpu::Framebuffer& from,
                      const gpu::Framebuffer& to) const {
    from.blitColorTo(to);
    if (!covered(scene, frame).setScissor()) {
        return;
    }
    to.bind();
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    from.color().bind(0);
    program_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
}

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
