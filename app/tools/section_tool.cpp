#include "app/tools/section_tool.h"

#include <Eigen/Geometry>

#include "app/tools/gizmo.h"
#include "app/tools/tool_marks.h"

namespace kerf::app {
namespace {

constexpr double kTipShare = 0.3;  // of the body's diagonal, from the middle handle to the tip
constexpr double kSideShare = 0.55;

/// The point of the plane nearest to the body's middle.
Vec3 middleOf(const render::SectionPlane& plane, const Bounds& bounds) {
    const Vec3 center = bounds.center();
    return center - plane.distance(center) * plane.normal;
}

}  // namespace

render::SectionPlane sectionAcross(const Bounds& bounds, const render::Camera& camera) {
    const Vec3 eye = camera.towardsEye(bounds.center());
    int axis = 0;
    eye.cwiseAbs().maxCoeff(&axis);
    return {bounds.center(), eye[axis] > 0 ? Vec3(Vec3::Unit(axis)) : Vec3(-Vec3::Unit(axis))};
}

std::array<Vec3, SectionTool::kHandles> SectionTool::handles(const render::SectionPlane& plane,
                                                             const Bounds& bounds) {
    const Vec3 at = middleOf(plane, bounds);
    return {at, at + kTipShare * bounds.diagonal() * plane.normal};
}

bool SectionTool::press(const ViewFrame& view, const Vec2& pixel, const render::SectionPlane& plane,
                        const Bounds& bounds) {
    held_ = handleAt(view, pixel, handles(plane, bounds));
    last_ = pixel;
    return held_.has_value();
}

render::SectionPlane SectionTool::moved(const ViewFrame& view, const Vec2& pixel,
                                        render::SectionPlane plane, const Bounds& bounds) {
    const auto [at, end] = handles(plane, bounds);
    if (held_ == middle) {
        const double reach = 0.5 * bounds.diagonal();
        const double from = plane.distance(bounds.center());
        const double shift = shiftTo(view, pixel, plane, bounds);
        // The plane stays where it meets the body's surroundings.
        plane.point = at + std::clamp(shift, from - reach, from + reach) * plane.normal;
    } else if (held_ == tip) {
        const Vec3 arm = view.onPlaneThrough(end, pixel) - at;
        if (arm.norm() > 1e-6 * bounds.diagonal()) {
            plane = {at, arm.normalized()};
        }
    }
    last_ = pixel;
    return plane;
}

/// How far along its normal the pointer wants the plane [m]: to the point of the normal's line that
/// is nearest to the line of sight. Where the normal points to the eye, upwards is forwards.
double SectionTool::shiftTo(const ViewFrame& view, const Vec2& pixel,
                            const render::SectionPlane& plane, const Bounds& bounds) const {
    const Vec3 at = middleOf(plane, bounds);
    if (const auto shift = alongAxis(view.rayThrough(pixel), at, plane.normal)) {
        return *shift;
    }
    const double perPixel =
        (view.onPlaneThrough(at, pixel) - view.onPlaneThrough(at, pixel + Vec2(0, 1))).norm();
    return (last_.y() - pixel.y()) * perPixel;
}

void SectionTool::addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
                        const render::SectionPlane& plane, const Bounds& bounds) const {
    const auto points = handles(plane, bounds);
    const double half = kSideShare * bounds.diagonal();
    const Vec3 along = half * plane.normal.unitOrthogonal();
    const Vec3 across = plane.normal.cross(along);
    const std::array<Vec3, 4> corners{
        points[middle] + along + across, points[middle] - along + across,
        points[middle] - along - across, points[middle] + along - across};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        view.addLine(corners[i], corners[(i + 1) % corners.size()], overlay.swept);
    }
    view.addLine(points[middle], points[tip], overlay.guides);
    addHandles(overlay, view, points, held_ ? held_ : handleAt(view, pixel, points));
}

}  // namespace kerf::app
