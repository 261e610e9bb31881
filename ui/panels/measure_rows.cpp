#include "ui/panels/measure_rows.h"

#include <imgui.h>

#include <array>
#include <string>

#include "ui/base/item_rects.h"
#include "ui/base/widgets.h"

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
        noteItem(std::string("measure.") + button.label);
        itemTooltip(button.tooltip);
    }
    return changed;
}

void drawRow(const MeasureRow& row, std::vector<Action>& actions) {
    ImGui::PushID(row.id);
    if (ImGui::SmallButton("\u00d7")) {
        actions.emplace_back(RemoveMeasure{row.id});
    }
    noteItem("measure.remove." + std::to_string(row.id));
    itemTooltip("Remove this measurement");
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
    if (ImGui::SmallButton("CSV")) {
        actions.emplace_back(ExportMeasures{});
    }
    noteItem("measure.csv");
    itemTooltip("Save the list as CSV in the current folder");
    ImGui::SameLine();
    if (ImGui::SmallButton("Remove all")) {
        actions.emplace_back(RemoveMeasure{});
    }
    noteItem("measure.clear");
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
