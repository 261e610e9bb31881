#include <imgui.h>

#include <array>
#include <string>

#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

struct KindButton {
    MeasureKind kind;
    const char* label;
    const char* tooltip;
};
constexpr std::array kKinds{
    KindButton{MeasureKind::distance, "Distance", "Click two points: straight-line distance"},
    KindButton{MeasureKind::angle, "Angle", "Click three points: angle at the second"},
    KindButton{MeasureKind::piece, "Piece", "Click a piece: areas and volume"},
    KindButton{MeasureKind::point, "Plot",
               "Click a point: plots its strain, displacement and speed over time"},
};

bool chooseKind(ToolSettings& tools) {
    bool changed = false;
    for (const KindButton& button : kKinds) {
        if (button.kind != kKinds.front().kind) {
            ImGui::SameLine();
        }
        const float width = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
                            ImGui::CalcTextSize(button.label).x;
        if (ImGui::GetContentRegionAvail().x < width) {
            ImGui::NewLine();
        }
        if (ImGui::RadioButton(button.label, tools.measure == button.kind)) {
            tools.measure = button.kind;
            changed = true;
        }
        describeItem(std::string("measure.") + button.label, button.tooltip);
    }
    return changed;
}

void drawRow(const MeasureRow& row, std::vector<Action>& actions) {
    ImGui::PushID(row.id);
    if (smallButton("\u00d7", "measure.remove." + std::to_string(row.id),
                    "Remove this measurement")) {
        actions.emplace_back(RemoveMeasure{row.id});
    }
    ImGui::SameLine();
    ImGui::BeginGroup();
    for (const MeasureFigure& figure : row.figures) {
        ImGui::TextDisabled("%s%s", figure.quantity.c_str(), row.isOld ? " (outdated)" : "");
        ImGui::SameLine();
        ImGui::TextUnformatted(figure.text.c_str());
    }
    ImGui::EndGroup();
    ImGui::PopID();
}

void drawList(const std::vector<MeasureRow>& measures, std::vector<Action>& actions) {
    for (const MeasureRow& row : measures) {
        drawRow(row, actions);
    }
    if (smallButton("CSV", "measure.csv", "Save the list as CSV in the current folder")) {
        actions.emplace_back(ExportMeasures{});
    }
    ImGui::SameLine();
    if (smallButton("Remove all", "measure.clear")) {
        actions.emplace_back(RemoveMeasure{});
    }
}

}  // namespace

bool drawMeasureRows(const std::vector<MeasureRow>& measures, ToolSettings& tools,
                     std::vector<Action>& actions) {
    const bool changed = chooseKind(tools);
    if (measures.empty()) {
        ImGui::TextDisabled("Click on the body.");
    } else {
        drawList(measures, actions);
    }
    return changed;
}

}  // namespace kerf::ui
