#include "render/passes/smooth_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

#include "sim/base/boxes.h"

namespace kerf::render {
namespace {

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

}  // namespace

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

}  // namespace kerf::render
