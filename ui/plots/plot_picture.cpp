#include "ui/plots/plot_picture.h"

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

// [pixels]
constexpr int kSheetMargin = 16;  // around the panels and between them
constexpr int kSheetTitle = 30;   // the line of the title

/// A panel in a child window of its own, whose width the plot fills.
void drawPanel(const PlotSheet& sheet, int number, float top, const PlotTimeline& timeline) {
    const int column = number % sheet.columns;
    const int row = number / sheet.columns;
    ImGui::SetCursorPos(
        {static_cast<float>(kSheetMargin + column * (sheet.panelWidth + kSheetMargin)),
         top + static_cast<float>(row * (sheet.panelHeight + kSheetMargin))});
    ImGui::PushID(number);
    ImGui::BeginChild(
        "panel", {static_cast<float>(sheet.panelWidth), static_cast<float>(sheet.panelHeight)});
    drawPlot(sheet.panels[static_cast<std::size_t>(number)], timeline,
             static_cast<float>(sheet.panelHeight));
    ImGui::EndChild();
    ImGui::PopID();
}

void drawSheet(const PlotSheet& sheet) {
    const PlotTimeline timeline{{}, newestOf(sheet.panels), false};
    ImGui::SetCursorPos({kSheetMargin, kSheetMargin});
    ImGui::TextUnformatted(sheet.title.c_str());
    const auto top = static_cast<float>(kSheetMargin + kSheetTitle);
    for (int number = 0; number < static_cast<int>(sheet.panels.size()); ++number) {
        drawPanel(sheet, number, top, timeline);
    }
}

}  // namespace

PlotPainter::PlotPainter(Theme theme, float scale) : painter_(theme, scale) {}

render::Image PlotPainter::draw(std::span<const PlotSpec> plots, const PlotView& view, int width,
                                int height) {
    return painter_.draw(width, height, [&] { drawAll(plots, view); });
}

render::Image PlotPainter::draw(const PlotSheet& sheet) {
    const auto rows = (static_cast<int>(sheet.panels.size()) + sheet.columns - 1) / sheet.columns;
    const int width = kSheetMargin + sheet.columns * (sheet.panelWidth + kSheetMargin);
    const int height = kSheetMargin + kSheetTitle + rows * (sheet.panelHeight + kSheetMargin);
    return painter_.draw(width, height, [&] { drawSheet(sheet); });
}

}  // namespace kerf::ui
