#include "app/tools/blade_preview.h"

#include "app/scene/editor_scene.h"
#include "app/scene/readout/cut_preview.h"
#include "app/tools/tool_marks.h"
#include "sim/mesh/triangle.h"
#include "sim/run/simulation.h"

namespace kerf::app {
namespace {

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
