#include "ui/panels/menu_bar.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ui/base/item_rects.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/state/action_table.h"
#include "ui/state/menu_icons.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {
namespace {

constexpr const char* kRoom = "     ";  // of an icon

/// The first row of each group below the first group of a menu.
constexpr std::array kGroupStarts{
    ActionId::saveSession, ActionId::exportBody,    ActionId::screenshot, ActionId::quit,
    ActionId::cancel,      ActionId::toggleGravity, ActionId::bringDown,  ActionId::slower,
    ActionId::record,      ActionId::addPicture,    ActionId::viewFront,  ActionId::wireframe,
    ActionId::nextField,   ActionId::togglePanels,  ActionId::about};

/// "Undo: Cut 2" where it is known what it takes back.
std::string labelOf(const PanelModel& model, const ActionRow& row) {
    const ChangeList& changes = model.changes;
    if (row.id == ActionId::undo && changes.done > 0) {
        return "Undo: " + changes.rows[changes.done - 1].name + "###undo";
    }
    if (row.id == ActionId::redo && changes.done < changes.rows.size()) {
        return "Redo: " + changes.rows[changes.done].name + "###redo";
    }
    return std::string(row.label);
}

void drawItem(const PanelModel& model, const ActionRow& row, std::vector<Action>& actions) {
    const std::string keys = keysOf(row.id);
    const bool available = isAvailable(model, row.id);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::MenuItemEx(labelOf(model, row).c_str(), kRoom, keys.c_str(), isOn(model, row.id),
                          available)) {
        actions.emplace_back(row.id);
    }
    noteItem("menu." + std::string(row.label));
    drawIcon(row.id, low, ImGui::GetFontSize(), available ? palette().text : palette().dimText);
}

void drawRecentFiles(const PanelModel& model, std::vector<Action>& actions) {
    if (!ImGui::BeginMenu("Open recent", !model.files.recent.empty())) {
        return;
    }
    for (const std::filesystem::path& file : model.files.recent) {
        ImGui::PushID(file.c_str());
        if (ImGui::MenuItem(file.filename().c_str())) {
            actions.emplace_back(FileAction(OpenFile{file}));
        }
        itemTooltip(file.string());
        noteItem("recent." + file.filename().string());
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

void drawMenu(const PanelModel& model, std::string_view group, std::vector<Action>& actions) {
    if (!ImGui::BeginMenu(std::string(group).c_str())) {
        return;
    }
    for (const ActionRow& row : actionTable()) {
        if (row.group == group) {
            if (std::ranges::find(kGroupStarts, row.id) != kGroupStarts.end()) {
                ImGui::Separator();
            }
            drawItem(model, row, actions);
        }
        if (row.group == group && row.id == ActionId::openFile) {
            drawRecentFiles(model, actions);
        }
    }
    ImGui::EndMenu();
}

std::vector<std::string_view> allGroups() {
    std::vector<std::string_view> groups;
    for (const ActionRow& row : actionTable()) {
        if (groups.empty() || groups.back() != row.group) {
            groups.push_back(row.group);
        }
    }
    return groups;
}

/// ImGui puts two of them beside each menu. In a narrow panel they give way to the words [px].
float gapBetween(const std::vector<std::string_view>& groups) {
    float words = 0;
    for (const std::string_view group : groups) {
        words += ImGui::CalcTextSize(group.data(), group.data() + group.size()).x;
    }
    const float free = ImGui::GetContentRegionAvail().x - words;
    return std::clamp(free / (2 * static_cast<float>(groups.size()) + 1), 1.0F,
                      ImGui::GetStyle().ItemSpacing.x);
}

}  // namespace

void drawMenuBar(const PanelModel& model, std::vector<Action>& actions) {
    if (!ImGui::BeginMenuBar()) {
        return;
    }
    const std::vector<std::string_view> groups = allGroups();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {gapBetween(groups), ImGui::GetStyle().ItemSpacing.y});
    for (const std::string_view group : groups) {
        drawMenu(model, group, actions);
    }
    ImGui::PopStyleVar();
    ImGui::EndMenuBar();
}

}  // namespace kerf::ui
