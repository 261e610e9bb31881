#include "ui/plots_panel.h"

#include <imgui.h>

#include <algorithm>

#include "ui/plot.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

void drawFramesPlot(const PanelModel& model, float height) {
    PlotSpec spec;
    spec.id = "frames";
    spec.title = "Frames per second";
    spec.color = Theme::kBlue;
    spec.points = model.history->framesPerSecond;
    spec.marks = model.history->marks;
    spec.minSpan = 10;
    drawPlot(spec, height);
}

void drawVolumePlot(const PanelModel& model, float height) {
    PlotSpec spec;
    spec.id = "volume";
    spec.title = "Volume, % of rest";
    spec.color = Theme::kGreen;
    spec.points = model.history->volumePercent;
    spec.marks = model.history->marks;
    spec.reference = 100;
    spec.minSpan = 1;
    spec.readoutDecimals = 2;
    drawPlot(spec, height);
}

}  // namespace

void drawPlots(const PanelModel& model, float height) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float each = std::max((height - 0.4F * line) / 2, 5 * line);
    drawFramesPlot(model, each);
    ImGui::Dummy({0, 0.2F * line});
    drawVolumePlot(model, each);
}

}  // namespace kerf::ui
