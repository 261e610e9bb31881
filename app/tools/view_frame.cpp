#include "app/tools/view_frame.h"

namespace kerf::app {

bool ViewFrame::operator==(const ViewFrame& other) const {
    const render::Camera& theirs = other.camera;
    return camera.eye == theirs.eye && camera.target == theirs.target && camera.up == theirs.up &&
           camera.fovY == theirs.fovY && camera.orthographic == theirs.orthographic &&
           camera.middle == theirs.middle && width == other.width && height == other.height;
}

std::optional<ui::PlotPoint> ViewFrame::toPixel(const Vec3& point) const {
    const Eigen::Vector4f at(static_cast<float>(point.x()), static_cast<float>(point.y()),
                             static_cast<float>(point.z()), 1.0F);
    const Eigen::Vector4f clip = camera.projection(aspect()) * camera.view() * at;
    if (clip.w() <= 0) {
        return std::nullopt;
    }
    return ui::PlotPoint{(clip.x() / clip.w() + 1) * 0.5 * width,
                         (1 - clip.y() / clip.w()) * 0.5 * height};
}

void ViewFrame::addLine(const Vec3& from, const Vec3& to,
                        std::vector<ui::Overlay::Line>& lines) const {
    const auto a = toPixel(from);
    const auto b = toPixel(to);
    if (a && b) {
        lines.push_back({*a, *b});
    }
}

Vec3 ViewFrame::onPlaneThrough(const Vec3& point, const Vec2& pixel) const {
    const double depth = (point - camera.eye).dot(camera.forward());
    return camera.pointAt(toNdc(pixel), aspect(), depth);
}

}  // namespace kerf::app
