#include "ui/help_overlay.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "ui/shortcuts.h"
#include "ui/theme.h"

namespace kerf::ui {
namespace {

void drawEntry(std::string_view keys, std::string_view label) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().of(Hue::blue));
    ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(label.data(), label.data() + label.size());
    ImGui::PopTextWrapPos();
}

void drawGroupTitle(std::string_view title) {
    ImGui::TableNextRow(0, 1.6F * ImGui::GetFontSize());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", std::string(title).c_str());
}

void drawKeys() {
    std::string_view group;
    for (const Shortcut& row : shortcutTable()) {
        if (&row != &shortcutOf(row.id)) {
            continue;  // A second key of the action stands with its first.
        }
        if (row.group != group) {
            group = row.group;
            drawGroupTitle(group);
        }
        drawEntry(keysOf(row.id), row.label);
    }
}

void drawTables() {
    if (!ImGui::BeginTable("help", 2, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 13);
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch);
    drawGroupTitle("Pointer");
    for (const PointerHint& row : pointerTable()) {
        drawEntry(row.gesture, row.label);
    }
    drawKeys();
    ImGui::EndTable();
}

}  // namespace

void drawHelp(const PanelModel& model, const Rect& view, std::vector<Action>& actions) {
    if (!model.helpOpen) {
        return;
    }
    const float width = std::min(view.width, ImGui::GetFontSize() * 38);
    ImGui::SetNextWindowPos({view.x + view.width / 2, view.y + view.height / 2}, ImGuiCond_Always,
                            {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, view.height});
    ImGui::Begin("Shortcuts", nullptr,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4, 2});
    drawTables();
    ImGui::PopStyleVar();
    if (ImGui::Button("Close")) {
        actions.emplace_back(ActionId::help);
    }
    ImGui::End();
}

}  // namespace kerf::ui
