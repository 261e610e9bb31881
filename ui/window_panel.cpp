#include "ui/window_panel.h"

#include <imgui.h>

#include <cmath>
#include <string>

#include "ui/item_rects.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

std::string scaleText(double scale) {
    return std::to_string(std::lround(100 * scale)) + " %";
}

bool chooseTheme(Settings& settings) {
    bool light = settings.theme == Theme::light;
    bool changed = ImGui::RadioButton("Dark", !light);
    noteItem("window.dark");
    light = changed ? false : light;
    ImGui::SameLine();
    if (ImGui::RadioButton("Light", light)) {
        light = changed = true;
    }
    noteItem("window.light");
    settings.theme = light ? Theme::light : Theme::dark;
    return changed;
}

bool chooseScale(Settings& settings) {
    bool changed = false;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##scale", scaleText(settings.uiScale).c_str())) {
        for (const double scale : kUiScales) {
            if (ImGui::Selectable(scaleText(scale).c_str(), scale == settings.uiScale)) {
                settings.uiScale = scale;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    noteItem("window.scale");
    return changed;
}

}  // namespace

void drawWindowRows(const PanelModel& model, std::vector<Action>& actions) {
    Settings settings = model.settings;
    rowLabel("Theme");
    bool changed = chooseTheme(settings);
    rowLabel("Size");
    itemTooltip("Of letters and panels, times what the display asks for");
    changed = chooseScale(settings) || changed;
    if (changed) {
        actions.emplace_back(SetSettings{settings});
    }
}

}  // namespace kerf::ui
