#include "ui/tools_panel.h"

#include <imgui.h>

#include <array>
#include <string>

#include "ui/action_table.h"
#include "ui/item_rects.h"
#include "ui/measure_rows.h"
#include "ui/panel_model.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

struct ToolButton {
    Tool tool;
    ActionId id;
    const char* label;
};
constexpr std::array kTools{
    ToolButton{Tool::stroke, ActionId::toolStroke, "Stroke"},
    ToolButton{Tool::scalpel, ActionId::toolScalpel, "Scalpel"},
    ToolButton{Tool::guillotine, ActionId::toolGuillotine, "Guillotine"},
    ToolButton{Tool::grab, ActionId::toolGrab, "Grab"},
    ToolButton{Tool::pin, ActionId::toolPin, "Pin"},
    ToolButton{Tool::retract, ActionId::toolRetract, "Retract"},
    ToolButton{Tool::move, ActionId::toolMove, "Move"},
    ToolButton{Tool::measure, ActionId::toolMeasure, "Measure"},
};
constexpr std::size_t kToolsInARow = 3;
constexpr double kLargestRadius = 0.2;  // of a hand or brush, of the longest blade

void drawToolButton(const ToolButton& button, bool chosen, float width,
                    std::vector<Action>& actions) {
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
    itemTooltip(describeAction(button.id));
}

void drawToolButtons(const PanelModel& model, std::vector<Action>& actions) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width =
        (ImGui::GetContentRegionAvail().x - (kToolsInARow - 1) * gap) / kToolsInARow;
    for (std::size_t i = 0; i < kTools.size(); ++i) {
        if (i % kToolsInARow > 0) {
            ImGui::SameLine(0, gap);
        }
        drawToolButton(kTools[i], model.tools.tool == kTools[i].tool, width, actions);
    }
}

/// A length from a hundredth of the longest one up. `beside`: width of what follows in its row.
bool slideLength(const char* label, double& value, double longest, const char* tooltip,
                 float beside = 0) {
    const double least = 0.01 * longest;
    const float gap = beside > 0 ? ImGui::GetStyle().ItemInnerSpacing.x : 0;
    return slideRow({label, tooltip, std::string("blade.") + label},
                    {ImGuiDataType_Double, &value, &least, &longest,
                     std::string(lengthFormat(longest)) + " m"},
                    ImGui::GetContentRegionAvail().x - beside - gap)
        .changed;
}

bool drawStrokeRows(ToolSettings& tools) {
    bool changed = ImGui::Checkbox("Through all", &tools.throughAll);
    noteItem("blade.through");
    itemTooltip("The blade reaches through the whole body along the line of sight");
    if (!tools.throughAll) {
        changed |= slideLength("Depth", tools.strokeDepth, tools.longest,
                               "How far the blade goes in, from the nearest point of the body");
    }
    return changed;
}

bool drawGuillotineRows(ToolSettings& tools, std::vector<Action>& actions) {
    bool changed = slideLength("Length", tools.length, tools.longest, "Length of the blade");
    changed |= slideLength("Drop", tools.drop, tools.longest, "How far the blade goes down");
    const double up = 0;
    const double down = 1;
    const float button = 4.6F * ImGui::GetFontSize();
    const float width = ImGui::GetContentRegionAvail().x - button;
    changed |= slideRow({"Lowered", "Pulls the blade down by hand, and cuts", "blade.lowered"},
                        {ImGuiDataType_Double, &tools.lowered, &up, &down, "%.2f"},
                        width - ImGui::GetStyle().ItemInnerSpacing.x)
                   .changed;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button("Down", {button, 0})) {
        actions.emplace_back(ActionId::bringDown);
    }
    noteItem("blade.down");
    itemTooltip(describeAction(ActionId::bringDown));
    return changed;
}

bool drawPinRows(ToolSettings& tools, std::vector<Action>& actions) {
    const float button = 5.4F * ImGui::GetFontSize();
    const bool changed = slideLength("Brush", tools.pinRadius, kLargestRadius * tools.longest,
                                     "How far around the pointer it pins", button);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::Button("Free all", {button, 0})) {
        actions.emplace_back(ActionId::freePins);
    }
    noteItem("pin.free");
    itemTooltip(describeAction(ActionId::freePins));
    return changed;
}

void drawRetractRow(const PanelModel& model, std::vector<Action>& actions) {
    const std::string label =
        model.body.hooks == 0 ? "No retractor holds a cut open" : "Remove the last";
    if (model.body.hooks == 0) {
        ImGui::TextDisabled("%s", label.c_str());
    } else if (ImGui::Button(label.c_str(), {-1, 0})) {
        actions.emplace_back(ActionId::removeRetractor);
    }
    noteItem("retract.remove");
    itemTooltip(describeAction(ActionId::removeRetractor));
}

bool drawRowsOf(const PanelModel& model, ToolSettings& tools, std::vector<Action>& actions) {
    switch (tools.tool) {
        case Tool::stroke:
            return drawStrokeRows(tools);
        case Tool::scalpel:
            return slideLength("Depth", tools.scalpelDepth, tools.longest,
                               "How deep the scalpel goes below the surface");
        case Tool::guillotine:
            return drawGuillotineRows(tools, actions);
        case Tool::grab:
            return slideLength("Hand", tools.grabRadius, kLargestRadius * tools.longest,
                               "How far around the pointer the hand takes hold");
        case Tool::pin:
            return drawPinRows(tools, actions);
        case Tool::retract:
            drawRetractRow(model, actions);
            return false;
        case Tool::move:
            return false;
        case Tool::measure:
            return drawMeasureRows(model.view.measures, tools, actions);
    }
    return false;
}

bool cuts(Tool tool) {
    return tool == Tool::stroke || tool == Tool::scalpel || tool == Tool::guillotine;
}

void drawTimeWhileCutting(const PanelModel& model, std::vector<Action>& actions) {
    bool runs = model.settings.timeRunsWhileCutting;
    if (ImGui::Checkbox("Time runs while cutting", &runs)) {
        actions.emplace_back(ActionId::timeWhileCutting);
    }
    noteItem("blade.time");
    itemTooltip("In a pause, a stroke cuts the body where it lies; with this it moves meanwhile");
}

}  // namespace

void drawTools(const PanelModel& model, std::vector<Action>& actions) {
    drawToolButtons(model, actions);
    ToolSettings tools = model.tools;
    if (drawRowsOf(model, tools, actions)) {
        actions.emplace_back(SetTools{tools});
    }
    if (cuts(model.tools.tool)) {
        drawTimeWhileCutting(model, actions);
    }
}

}  // namespace kerf::ui
