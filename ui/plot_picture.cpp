#include "ui/plot_picture.h"

#include <imgui.h>

namespace kerf::ui {
namespace {

void drawAll(std::span<const PlotSpec> plots, const PlotView& view) {
    const PlotTimeline timeline{view, newestOf(plots), false};
    const float gaps = ImGui::GetStyle().ItemSpacing.y * static_cast<float>(plots.size());
    const float room = ImGui::GetContentRegionAvail().y - gaps;
    for (const PlotSpec& plot : plots) {
        drawPlot(plot, timeline, room / static_cast<float>(plots.size()));
    }
}

}  // namespace

PlotPainter::PlotPainter(Theme theme, float scale) : painter_(theme, scale) {}

render::Image PlotPainter::draw(std::span<const PlotSpec> plots, const PlotView& view, int width,
                                int height) {
    return painter_.draw(width, height, [&] { drawAll(plots, view); });
}

}  // namespace kerf::ui
