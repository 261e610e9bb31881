#include "app/tools/tool_marks.h"

#include "app/scene/editor_scene.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {

namespace {

constexpr int kMostTriangles = 50'000;  // for a look at all of the body
constexpr int kRingPoints = 40;

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

void addSwept(ui::Overlay& overlay, const std::vector<Blade>& way, const ViewFrame& view) {
    for (std::size_t i = 1; i < way.size(); ++i) {
        view.addLine(way[i - 1].a, way[i].a, overlay.swept);
        view.addLine(way[i - 1].b, way[i].b, overlay.swept);
    }
    view.addLine(way.front().a, way.front().b, overlay.swept);
    view.addLine(way.back().a, way.back().b, overlay.swept);
}

void addLag(ui::Overlay& overlay, const std::vector<Blade>& way, const ViewFrame& view) {
    for (const Blade& pose : way) {
        if (const auto at = view.toPixel(0.5 * (pose.a + pose.b))) {
            overlay.lag.push_back(*at);
        }
    }
}

void addPreview(ui::Overlay& overlay, const std::vector<Blade>& way, const ToolContext& c) {
    const std::vector<Blade> few = thinned(way);
    if (!few.empty()) {
        addSwept(overlay, few, c.view);
    }
    if (few.size() > 1 && c.scene != nullptr && !isLarge(*c.scene)) {
        const CutPreview& preview = c.scene->preview(few);
        if (c.showsAhead) {
            addTouched(c.view, c.scene->simulation().meshAsRead(), preview.touched, overlay);
        }
        for (const auto& line : preview.wound) {
            c.view.addLine(line[0], line[1], overlay.wound);
        }
    }
}

}  // namespace kerf::app
