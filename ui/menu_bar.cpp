#include "ui/menu_bar.h"

#include <imgui.h>

#include <string>

#include "ui/action_table.h"
#include "ui/item_rects.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

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
    if (ImGui::MenuItem(labelOf(model, row).c_str(), keys.c_str(), isOn(model, row.id),
                        isAvailable(model, row.id))) {
        actions.emplace_back(row.id);
    }
}

void drawRecentFiles(const PanelModel& model, std::vector<Action>& actions) {
    if (!ImGui::BeginMenu("Open again", !model.recentFiles.empty())) {
        return;
    }
    for (const std::filesystem::path& file : model.recentFiles) {
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
    for (const ActionRow& row : kActions) {
        if (row.group == group) {
            drawItem(model, row, actions);
        }
        if (row.group == group && row.id == ActionId::openFile) {
            drawRecentFiles(model, actions);
        }
    }
    ImGui::EndMenu();
}

}  // namespace

void drawMenuBar(const PanelModel& model, std::vector<Action>& actions) {
    if (!ImGui::BeginMenuBar()) {
        return;
    }
    std::string_view last;
    for (const ActionRow& row : kActions) {
        if (row.group != last) {
            last = row.group;
            drawMenu(model, last, actions);
        }
    }
    ImGui::EndMenuBar();
}

}  // namespace kerf::ui
