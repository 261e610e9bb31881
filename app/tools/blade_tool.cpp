#include "app/tools/blade_tool.h"

#include <algorithm>

#include "app/scene/cut_preview.h"
#include "app/scene/editor_stroke.h"
#include "app/tools/tool_limits.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

// Shares of the body's diagonal.
constexpr double kStrokeDepth = 0.25;
constexpr double kScalpelDepth = 0.06;
constexpr double kGrabRadius = 0.12;
constexpr double kPinRadius = 0.08;
constexpr double kLongest = 2;

const Vec2 kNowhere(-1e5, -1e5);  // [px]
constexpr std::size_t kMostPreviewPoses = 32;

/// At most so many poses, the ends among them.
std::vector<Blade> thinned(const std::vector<Blade>& way) {
    if (way.size() <= kMostPreviewPoses) {
        return way;
    }
    std::vector<Blade> few;
    for (std::size_t i = 0; i < kMostPreviewPoses; ++i) {
        few.push_back(way[i * (way.size() - 1) / (kMostPreviewPoses - 1)]);
    }
    return few;
}

/// The outline of the way.
void addSwept(const ViewFrame& view, const std::vector<Blade>& way, ui::Overlay& overlay) {
    for (std::size_t i = 1; i < way.size(); ++i) {
        view.addLine(way[i - 1].a, way[i].a, overlay.swept);
        view.addLine(way[i - 1].b, way[i].b, overlay.swept);
    }
    view.addLine(way.front().a, way.front().b, overlay.swept);
    view.addLine(way.back().a, way.back().b, overlay.swept);
}

/// Adds the triangles that face the eye.
void addTouched(const ViewFrame& view, const SurfaceMesh& mesh, const std::vector<int>& triangles,
                ui::Overlay& overlay) {
    for (const int t : triangles) {
        const Corners at = cornersOf(mesh, t);
        const auto a = view.toPixel(at[0]);
        const auto b = view.toPixel(at[1]);
        const auto c = view.toPixel(at[2]);
        if (areaNormal(at).dot(view.camera.towardsEye(at[0])) > 0 && a && b && c) {
            overlay.touched.push_back({*a, *b, *c});
        }
    }
}

}  // namespace

void BladeTool::fitTo(const Bounds& bounds) {
    const double diagonal = bounds.diagonal();
    settings_.strokeDepth = kStrokeDepth * diagonal;
    settings_.scalpelDepth = kScalpelDepth * diagonal;
    settings_.grabRadius = kGrabRadius * diagonal;
    settings_.pinRadius = kPinRadius * diagonal;
    settings_.longest = kLongest * diagonal;
    settings_.lowered = 0;
    guillotine_ = Guillotine(bounds);
    settings_.length = guillotine_.length();
    settings_.drop = guillotine_.drop();
    scalpel_.reset();
    handle_.reset();
    gizmo_.release();
    held_ = false;
}

void BladeTool::set(const ui::ToolSettings& settings, EditorScene& scene) {
    const ui::ToolSettings before = settings_;
    settings_ = settings;
    if (settings.tool != before.tool) {
        settings_.lowered = before.lowered;
        cancel(scene);
        return;
    }
    if (settings.length != before.length || settings.drop != before.drop) {
        raise(scene);
        guillotine_.setLength(settings.length);
        guillotine_.setDrop(settings.drop);
    } else if (settings.lowered != before.lowered) {
        settings_.lowered = before.lowered;
        lowerTo(settings.lowered, scene);
    }
}

// --- The pointer -------------------------------------------------------------------------------

void BladeTool::press(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    switch (settings_.tool) {
        case ui::Tool::stroke:
            pressStroke(view, pixel, scene);
            return;
        case ui::Tool::scalpel:
            held_ = true;
            scalpel_.reset();
            moveScalpel(view, pixel, scene);
            return;
        case ui::Tool::guillotine:
            heldGuillotine_ = guillotine_;
            handle_ = handleAt(view, pixel);
            if (!handle_) {
                gizmo_.press(view, pixel, frameOfGuillotine());
            }
            return;
        case ui::Tool::grab:
        case ui::Tool::pin:
        case ui::Tool::retract:
        case ui::Tool::move:
        case ui::Tool::measure:
            return;  // see PullTool, RetractTool, MoveTool, MeasureList
    }
}

void BladeTool::pressStroke(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    const std::optional<double> depth =
        settings_.throughAll ? std::nullopt : std::optional(settings_.strokeDepth);
    // Where an earlier stroke is still being cut, this one's poses queue up behind it.
    scene.stroke().begin(
        StrokeSpace(view.camera, view.aspect(), scene.simulation().bounds(), depth),
        view.toNdc(pixel));
    ruler_.emplace(pixel);
    held_ = true;
}

void BladeTool::move(const ViewFrame& view, const Vec2& pixel, const ui::Modifiers& modifiers,
                     EditorScene& scene) {
    if (handle_ || gizmo_.holds()) {
        moveGuillotine(view, pixel, modifiers.control, scene);
    } else if (held_ && settings_.tool == ui::Tool::scalpel) {
        moveScalpel(view, pixel, scene);
    } else if (held_) {
        const std::optional<Vec2> to = modifiers.shift ? ruler_->along(pixel) : pixel;
        if (to) {
            scene.stroke().moveTo(view.toNdc(*to));
        }
    }
}

void BladeTool::moveGuillotine(const ViewFrame& view, const Vec2& pixel, bool snaps,
                               EditorScene& scene) {
    raise(scene);
    if (handle_) {
        guillotine_.move(*handle_, view.onPlaneThrough(guillotine_.handles()[*handle_], pixel));
    } else {
        const GizmoChange change = gizmo_.moved(view, pixel, snaps);
        guillotine_ = heldGuillotine_.moved(change.by, change.turn);
    }
    settings_.length = guillotine_.length();
    settings_.drop = guillotine_.drop();
}

void BladeTool::moveScalpel(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) {
    const auto point = scene.pick(view.rayThrough(pixel));
    if (!point) {
        scalpel_.reset();
        scene.stroke().end();
        return;
    }
    if (!scalpel_) {
        scalpel_.emplace(settings_.scalpelDepth);
    }
    for (const Blade& pose : scalpel_->moveTo(*point)) {
        if (scene.stroke().drawing()) {
            scene.stroke().moveTo(pose);
        } else {
            scene.stroke().begin(pose, {0.5, maxStrokeStep(scene.simulation().bounds())});
        }
    }
}

void BladeTool::release(EditorScene& scene) {
    handle_.reset();
    gizmo_.release();
    scalpel_.reset();
    if (held_) {
        held_ = false;
        scene.stroke().end();
    }
}

void BladeTool::cancel(EditorScene& scene) {
    if (handle_ || gizmo_.holds()) {
        guillotine_ = heldGuillotine_;
        settings_.length = guillotine_.length();
        settings_.drop = guillotine_.drop();
    }
    handle_.reset();
    gizmo_.release();
    scalpel_.reset();
    held_ = false;
    settings_.lowered = 0;
    scene.stroke().cancel();
}

// --- The guillotine ----------------------------------------------------------------------------

void BladeTool::bringDown(EditorScene& scene) {
    if (settings_.tool == ui::Tool::guillotine) {
        if (settings_.lowered >= 1) {
            settings_.lowered = 0;
        }
        lowerTo(1, scene);
    }
}

/// Down it cuts; pulled up it is out of the body and above it again.
void BladeTool::lowerTo(double lowered, EditorScene& scene) {
    if (lowered <= settings_.lowered) {
        raise(scene);
        return;
    }
    if (!scene.stroke().drawing()) {
        scene.stroke().begin(guillotine_.at(settings_.lowered),
                             {0.5, maxStrokeStep(scene.simulation().bounds())});
    }
    settings_.lowered = lowered;
    scene.stroke().moveTo(guillotine_.at(lowered));
    if (lowered >= 1) {
        scene.stroke().end();
    }
}

void BladeTool::raise(EditorScene& scene) {
    if (settings_.lowered > 0) {
        scene.stroke().end();
        settings_.lowered = 0;
    }
}

GizmoFrame BladeTool::frameOfGuillotine() const {
    return {guillotine_.center(), guillotine_.axes()};
}

std::optional<Guillotine::Handle> BladeTool::handleAt(const ViewFrame& view,
                                                      const Vec2& pixel) const {
    std::optional<Guillotine::Handle> best;
    double nearest = kHandleReach;
    const auto handles = guillotine_.handles();
    for (int i = 0; i < Guillotine::kHandles; ++i) {
        if (const auto at = view.toPixel(handles[i])) {
            const double distance = (Vec2(at->x, at->y) - pixel).norm();
            if (distance < nearest) {
                nearest = distance;
                best = static_cast<Guillotine::Handle>(i);
            }
        }
    }
    return best;
}

// --- What the coming cut will do ---------------------------------------------------------------

std::vector<Blade> BladeTool::wayAhead(const ViewFrame& view, const Vec2& pixel,
                                       EditorScene& scene) const {
    const BladeStroke& stroke = scene.stroke();
    if (stroke.drawing() || stroke.pending() > 0) {
        return stroke.wayAhead();
    }
    if (settings_.tool == ui::Tool::guillotine && settings_.lowered < 1) {
        return {guillotine_.at(settings_.lowered), guillotine_.at(1)};
    }
    if (settings_.tool == ui::Tool::scalpel) {
        const auto point = scene.pick(view.rayThrough(pixel));
        if (point) {
            return {Scalpel(settings_.scalpelDepth).at(*point)};
        }
    }
    return {};
}

ui::Overlay BladeTool::swept(const ViewFrame& view, const BladeStroke& stroke) {
    ui::Overlay overlay;
    if (const std::vector<Blade> way = thinned(stroke.wayAhead()); !way.empty()) {
        addSwept(view, way, overlay);
    }
    return overlay;
}

ui::Overlay BladeTool::overlay(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) const {
    ui::Overlay overlay;
    const std::vector<Blade> way = thinned(wayAhead(view, pixel, scene));
    if (!way.empty()) {
        addSwept(view, way, overlay);
    }
    if (way.size() > 1 && scene.simulation().report().triangles <= kMostPreviewTriangles) {
        const CutPreview& preview = scene.preview(way);
        addTouched(view, scene.simulation().meshAsRead(), preview.touched, overlay);
        for (const auto& line : preview.wound) {
            view.addLine(line[0], line[1], overlay.wound);
        }
    }
    if (settings_.tool == ui::Tool::guillotine) {
        if (way.empty()) {
            addSwept(view, {guillotine_.at(0), guillotine_.at(1)}, overlay);  // where it came down
        }
        if (!handle_) {
            const bool free = !handleAt(view, pixel).has_value();
            gizmo_.addTo(overlay, view, free ? pixel : kNowhere, frameOfGuillotine());
        }
        addHandles(view, pixel, overlay);
    }
    return overlay;
}

void BladeTool::addHandles(const ViewFrame& view, const Vec2& pixel, ui::Overlay& overlay) const {
    const std::optional<Guillotine::Handle> hot = handle_ ? handle_ : handleAt(view, pixel);
    const auto handles = guillotine_.handles();
    for (int i = 0; i < Guillotine::kHandles; ++i) {
        if (const auto at = view.toPixel(handles[i])) {
            overlay.handles.push_back({*at, hot == static_cast<Guillotine::Handle>(i)});
        }
    }
}

}  // namespace kerf::app
