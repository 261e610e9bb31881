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

void drawStage(const char* name, double milliseconds) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::Text("%.2f ms", milliseconds);
}

void drawStages(const StageTimes& stages) {
    sectionTitle("Time of the last step");
    if (ImGui::BeginTable("stages", 2, ImGuiTableFlags_RowBg)) {
        drawStage("Deform", stages.deform);
        drawStage("Collide", stages.collide);
        drawStage("Cut", stages.cut);
        drawStage("Frame", stages.frame);
        ImGui::EndTable();
    }
}

}  // namespace

void drawPlots(const PanelModel& model) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float stagesHeight = 7.2F * line;
    const float room = ImGui::GetContentRegionAvail().y - stagesHeight - 1.5F * line;
    const float height = std::clamp(room / 2, 5 * line, 12 * line);
    drawFramesPlot(model, height);
    ImGui::Dummy({0, 0.2F * line});
    drawVolumePlot(model, height);
    drawStages(model.stages);
}

}  // namespace kerf::ui
