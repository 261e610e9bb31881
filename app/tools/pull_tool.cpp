#include "app/tools/pull_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/scene/cut_preview.h"
#include "app/scene/held_hands.h"
#include "app/tools/tool_limits.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

constexpr double kBrushSpacing = 8;     // between two dabs of a fast drag [px]
constexpr double kLeastBox = 4;         // a smaller one was a click [px]
constexpr double kBoxMargin = 0.01;     // beyond the body, of its diagonal
constexpr double kFarthestCorner = 20;  // of a box to be pinned, of the distance to the body
constexpr int kRingPoints = 40;

/// A circle on the surface.
void addRing(const ViewFrame& view, const SurfacePoint& point, double radius,
             ui::Overlay& overlay) {
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

void addBox(const ViewFrame& view, const Bounds& box, ui::Overlay& overlay) {
    for (int corner = 0; corner < 8; ++corner) {
        for (const int bit : {1, 2, 4}) {
            if ((corner & bit) == 0) {
                view.addLine(box.corner(corner), box.corner(corner | bit), overlay.guides);
            }
        }
    }
}

/// Whether all of the body would be looked at for a picture, while it moves or is large.
bool isCostly(const EditorScene& scene) {
    return scene.running() || scene.simulation().report().triangles > kMostPreviewTriangles;
}

/// How far the tool reaches around the point of the surface that it is over, none where it does not
/// go by the surface [m].
std::optional<double> reachOf(const ui::ToolSettings& settings) {
    switch (settings.tool) {
        case ui::Tool::scalpel:
            return settings.scalpelDepth;
        case ui::Tool::grab:
            return settings.grabRadius;
        case ui::Tool::pin:
            return settings.pinRadius;
        case ui::Tool::stroke:
        case ui::Tool::guillotine:
        case ui::Tool::retract:
        case ui::Tool::move:
        case ui::Tool::measure:
            break;
    }
    return std::nullopt;
}

}  // namespace

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
    Bounds box;
    box.add(onPlane(from));
    box.add(onPlane(to));
    const double margin = kBoxMargin * body.diagonal();
    box.low[axis] = body.low[axis] - margin;
    box.high[axis] = body.high[axis] + margin;
    return box;
}

std::string PullTool::press(const ViewFrame& view, const Vec2& pixel,
                            const ui::ToolSettings& settings, const ui::Modifiers& modifiers,
                            EditorScene& scene) {
    if (settings.tool == ui::Tool::pin && modifiers.shift) {
        box_ = Box{!modifiers.control, pixel, pixel};
        return "";
    }
    if (settings.tool == ui::Tool::pin) {
        brush_ = Brush{settings.pinRadius, !modifiers.control, false, pixel};
        paint(view, pixel, scene);
        return "";
    }
    const auto point =
        settings.tool == ui::Tool::grab ? scene.pick(view.rayThrough(pixel)) : std::nullopt;
    if (!point) {
        return "";
    }
    std::string problem = scene.hands().grab(point->position, settings.grabRadius);
    if (problem.empty()) {
        held_ = to_ = point->position;
    }
    return problem;
}

void PullTool::move(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    if (held_) {
        to_ = view.onPlaneThrough(*held_, pixel);
        scene.hands().dragTo(to_);
    } else if (brush_) {
        paintUpTo(view, pixel, scene);
    } else if (box_) {
        box_->to = pixel;
    }
}

void PullTool::paintUpTo(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    const Vec2 from = brush_->last;
    const int dabs =
        std::max(1, static_cast<int>(std::ceil((pixel - from).norm() / kBrushSpacing)));
    for (int k = 1; k <= dabs; ++k) {
        paint(view, from + (pixel - from) * k / dabs, scene);
    }
    brush_->last = pixel;
}

/// Where all is pinned already nothing changes; that is no problem.
void PullTool::paint(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    const auto point = scene.pick(view.rayThrough(pixel));
    if (point &&
        scene.execute(Pin{Ball{point->position, brush_->radius}, brush_->pins, brush_->begun})
            .empty()) {
        brush_->begun = true;
    }
}

std::string PullTool::release(const ViewFrame& view, EditorScene& scene) {
    std::string problem;
    if (box_ && (box_->to - box_->from).norm() >= kLeastBox) {
        const Bounds box = boxBetween(view, box_->from, box_->to, scene.simulation().bounds());
        problem = scene.execute(Pin{box, box_->pins});
    }
    cancel(scene);
    return problem;
}

void PullTool::cancel(EditorScene& scene) {
    if (held_) {
        scene.hands().letGo();
    }
    *this = PullTool{};
}

void PullTool::addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
                     const ui::ToolSettings& settings, EditorScene& scene) const {
    if (held_) {
        if (const auto at = view.toPixel(to_)) {
            overlay.handles.push_back({*at, true});
        }
        return;
    }
    if (box_) {
        addBox(view, boxBetween(view, box_->from, box_->to, scene.simulation().bounds()), overlay);
        return;
    }
    if (const std::optional<double> radius = reachOf(settings)) {
        if (const auto point = scene.pick(view.rayThrough(pixel))) {
            const bool fits = settings.tool == ui::Tool::grab && !isCostly(scene);
            const double reach = fits ? scene.hands().reachAt(point->position, *radius) : *radius;
            addRing(view, *point, reach, overlay);
        }
    }
}

}  // namespace kerf::app
