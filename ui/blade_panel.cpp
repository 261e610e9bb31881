#include "ui/blade_panel.h"

#include <imgui.h>

#include <array>
#include <string>

#include "ui/item_places.h"
#include "ui/shortcuts.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

struct ToolButton {
    BladeTool tool;
    ActionId id;
    const char* label;
};
constexpr std::array kTools{
    ToolButton{BladeTool::stroke, ActionId::toolStroke, "Stroke"},
    ToolButton{BladeTool::scalpel, ActionId::toolScalpel, "Scalpel"},
    ToolButton{BladeTool::guillotine, ActionId::toolGuillotine, "Guillotine"},
};

void drawTools(const PanelModel& model, std::vector<Action>& actions) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / kTools.size();
    for (const ToolButton& button : kTools) {
        const bool chosen = model.blade.tool == button.tool;
        if (chosen) {
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
        }
        if (ImGui::Button(button.label, {width, 0})) {
            actions.emplace_back(button.id);
        }
        if (chosen) {
            ImGui::PopStyleColor();
        }
        noteItem(std::string("tool.") + button.label);
        itemTooltip(describeShortcut(button.id));
        if (&button != &kTools.back()) {
            ImGui::SameLine(0, gap);
        }
    }
}

/// A length from a hundredth of the longest one up.
bool slideLength(const char* label, double& value, double longest, const char* tooltip) {
    const double least = 0.01 * longest;
    const std::string format = std::string(label) + " %.3f m";
    ImGui::PushID(label);
    ImGui::SetNextItemWidth(-1);
    const bool changed =
        ImGui::SliderScalar("##length", ImGuiDataType_Double, &value, &least, &longest,
                            format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    noteItem(std::string("blade.") + label);
    ImGui::PopID();
    itemTooltip(tooltip);
    return changed;
}

bool drawStrokeRows(BladeSettings& blade) {
    bool changed = ImGui::Checkbox("Through all", &blade.throughAll);
    noteItem("blade.through");
    itemTooltip("The blade reaches through the whole body along the line of sight");
    if (!blade.throughAll) {
        changed |= slideLength("Depth", blade.strokeDepth, blade.longest,
                               "How far the blade goes in, from the nearest point of the body");
    }
    return changed;
}

bool drawGuillotineRows(BladeSettings& blade, std::vector<Action>& actions) {
    bool changed = slideLength("Length", blade.length, blade.longest, "Length of the blade");
    changed |= slideLength("Drop", blade.drop, blade.longest, "How far the blade goes down");
    const double up = 0;
    const double down = 1;
    const float button = 4.6F * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemInnerSpacing.x);
    changed |= ImGui::SliderScalar("##lowered", ImGuiDataType_Double, &blade.lowered, &up, &down,
                                   "Lowered %.2f", ImGuiSliderFlags_AlwaysClamp);
    noteItem("blade.lowered");
    itemTooltip("Pulls the blade down by hand, and cuts");
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button("Down", {button, 0})) {
        actions.emplace_back(ActionId::bringDown);
    }
    noteItem("blade.down");
    itemTooltip(describeShortcut(ActionId::bringDown));
    return changed;
}

bool drawRowsOf(BladeSettings& blade, std::vector<Action>& actions) {
    switch (blade.tool) {
        case BladeTool::stroke:
            return drawStrokeRows(blade);
        case BladeTool::scalpel:
            return slideLength("Depth", blade.scalpelDepth, blade.longest,
                               "How deep the scalpel goes below the surface");
        case BladeTool::guillotine:
            return drawGuillotineRows(blade, actions);
    }
    return false;
}

}  // namespace

void drawBlade(const PanelModel& model, std::vector<Action>& actions) {
    sectionTitle("Blade");
    drawTools(model, actions);
    BladeSettings blade = model.blade;
    if (drawRowsOf(blade, actions)) {
        actions.emplace_back(SetBlade{blade});
    }
}

}  // namespace kerf::ui
