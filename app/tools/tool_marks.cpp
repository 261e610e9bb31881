#include "app/tools/tool_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/scene/editor_scene.h"
#include "app/scene/readout/cut_preview.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

constexpr int kMostTriangles = 50'000;  // for a look at all of the body
constexpr int kRingPoints = 40;

}  // namespace

bool isLarge(const EditorScene& scene) {
    return scene.simulation().report().triangles > kMostTriangles;
}

bool isCostlyToFollow(const EditorScene& scene) {
    return scene.running() || isLarge(scene);
}

std::optional<int> handleAt(const ViewFrame& view, const Vec2& pixel,
                            std::span<const Vec3> handles) {
    std::optional<int> best;
    double nearest = kHandleReach;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const auto at = view.toPixel(handles[i]);
        const double away = at ? (Vec2(at->x, at->y) - pixel).norm() : nearest;
        if (away < nearest) {
            nearest = away;
            best = static_cast<int>(i);
        }
    }
    return best;
}

void addHandles(ui::Overlay& overlay, const ViewFrame& view, std::span<const Vec3> handles,
                std::optional<int> hot) {
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (const auto at = view.toPixel(handles[i])) {
            overlay.handles.push_back({*at, hot == static_cast<int>(i)});
        }
    }
}

bool isOnHandle(const ui::Overlay& overlay) {
    return std::ranges::any_of(overlay.handles, &ui::Overlay::Handle::hot) ||
           std::ranges::any_of(overlay.axisLines, &ui::Overlay::AxisLine::hot) ||
           std::ranges::any_of(overlay.axisDots, &ui::Overlay::AxisDot::hot);
}

void addRing(ui::Overlay& overlay, const ViewFrame& view, const SurfacePoint& point,
             double radius) {
    const Vec3 u = point.normal.unitOrthogonal();
    const Vec3 v = point.normal.cross(u);
    const auto at = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / kRingPoints;
        return Vec3(point.position + radius * (std::cos(angle) * u + std::sin(angle) * v));
    };
    for (int i = 0; i < kRingPoints; ++i) {
        view.addLine(at(i), at(i + 1), overlay.guides);
    }
}

}  // namespace kerf::app
