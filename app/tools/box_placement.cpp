#include "app/tools/box_placement.h"

#include "sim/base/math.h"

namespace kerf::app {
namespace {

constexpr double kBoxMargin = 0.01;     // beyond the body, of its diagonal
constexpr double kFarthestCorner = 20;  // of a box to be pinned, of the distance to the body

}  // namespace

StaticBox boxBeside(const Bounds& body, std::optional<double> floor, const Vec3& direction) {
    const double side = std::clamp(body.diagonal() / 3, kLeastBoxSize, kLargestBoxSize);
    const double ground = floor.value_or(body.low.y());
    const Vec3 half = 0.5 * (body.high - body.low);
    StaticBox box;
    box.size = Vec3::Constant(side);
    box.center = body.center() + (half + Vec3::Constant(side)).cwiseProduct(direction);
    box.center.y() = ground + side / 2;
    box.center = box.center.cwiseMax(-kFarthestBox).cwiseMin(kFarthestBox);
    return box;
}

StaticBox boxInView(const Bounds& body, std::optional<double> floor, const ViewFrame& view,
                    const ui::Rect& free) {
    const Vec3 right = view.camera.forward().cross(view.camera.up);
    std::array<Vec3, 4> directions{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitZ()};
    // The right one first, then the left one, then those before and behind.
    std::ranges::stable_sort(directions, std::greater{}, [&](const Vec3& direction) {
        const double sideways = direction.dot(right);
        return std::abs(sideways) + (sideways > 0 ? 0.01 : 0) * right.norm();
    });
    const auto boxAt = [&](const Vec3& direction) { return boxBeside(body, floor, direction); };
    const auto* seen = std::ranges::find_if(
        directions, [&](const Vec3& direction) { return isInView(boxAt(direction), view, free); });
    return boxAt(seen == directions.end() ? directions.front() : *seen);
}

bool isInView(const StaticBox& box, const ViewFrame& view, const ui::Rect& free) {
    for (int corner = 0; corner < 8; ++corner) {
        const auto at = view.toPixel(box.bounds().corner(corner));
        if (!at || at->x < free.x || at->x > free.x + free.width || at->y < free.y ||
            at->y > free.y + free.height) {
            return false;
        }
    }
    return true;
}

Bounds boxBetween(const ViewFrame& view, const Vec2& from, const Vec2& to, const Bounds& body) {
    int axis = 0;
    view.camera.forward().cwiseAbs().maxCoeff(&axis);
    const auto onPlane = [&](const Vec2& pixel) {
        const render::Ray ray = view.rayThrough(pixel);
        double way = (body.center()[axis] - ray.origin[axis]) / ray.direction[axis];
        // A pointer far outside of the window may look past the plane.
        const double most = kFarthestCorner * (body.center() - ray.origin).norm();
        if (!view.camera.orthographic && !(way >= 0)) {
            way = most;
        }
        return Vec3(ray.origin + std::clamp(way, -most, most) * ray.direction);
    };
    Bounds box = boxOf({onPlane(from), onPlane(to)});
    const double margin = kBoxMargin * body.diagonal();
    box.low[axis] = body.low[axis] - margin;
    box.high[axis] = body.high[axis] + margin;
    return box;
}

}  // namespace kerf::app
