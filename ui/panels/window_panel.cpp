#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

std::string scaleText(double scale) {
    return std::to_string(std::lround(100 * scale)) + " %";
}

bool chooseTheme(Settings& settings) {
    bool light = settings.theme == Theme::light;
    const bool changed = ImGui::Checkbox("Light theme", &light);
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

/// As in programs that people know.
bool chooseMouse(Settings& settings) {
    bool changed = false;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##mouse", rowOf(settings.mouse).label.data())) {
        for (int i = 0; i < kMouseSchemes; ++i) {
            const auto scheme = static_cast<MouseScheme>(i);
            if (ImGui::Selectable(rowOf(scheme).label.data(), scheme == settings.mouse)) {
                settings.mouse = scheme;
                changed = true;
            }
            noteItem("mouse." + std::string(rowOf(scheme).id));
        }
        ImGui::EndCombo();
    }
    noteItem("window.mouse");
    return changed;
}

}  // namespace

void drawWindowRows(const Settings& chosen, std::vector<Action>& actions) {
    Settings settings = chosen;
    bool changed = chooseTheme(settings);
    rowLabel("UI scale");
    itemTooltip("Size of text and panels, relative to the display's scale");
    changed |= chooseScale(settings);
    rowLabel("Mouse");
    itemTooltip("How dragging rotates and pans the view (listed by F1)");
    changed |= chooseMouse(settings);
    changed |= checkbox(
        "Autosave for recovery", settings.keepsJournal, "window.journal",
        "Your actions are saved at once, so that nothing is lost if Kerf closes unexpectedly");
    changed |= checkbox(
        "Software renderer", settings.softwareRenderer, "window.software",
        "Draw and compute on the CPU, from the next start on: slower, but correct where the "
        "graphics driver is faulty (kerf doctor checks that)");
    if (changed) {
        actions.emplace_back(SetSettings{settings});
    }
}

}  // namespace kerf::ui
