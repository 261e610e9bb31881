#include "ui/menu_bar.h"

#include <imgui.h>

#include <string>

#include "ui/display_switch.h"
#include "ui/item_places.h"
#include "ui/shortcuts.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

/// "Undo: Cut 2" where it is known what it takes back.
std::string labelOf(const PanelModel& model, const Shortcut& row) {
    const ChangeList& changes = model.changes;
    if (row.id == ActionId::undo && changes.done > 0) {
        return "Undo: " + changes.rows[changes.done - 1].name + "###undo";
    }
    if (row.id == ActionId::redo && changes.done < changes.rows.size()) {
        return "Redo: " + changes.rows[changes.done].name + "###redo";
    }
    return std::string(row.label);
}

void drawItem(const PanelModel& model, const Shortcut& row, std::vector<Action>& actions) {
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
    for (const Shortcut& row : shortcutTable()) {
        if (row.group == group && &row == &shortcutOf(row.id)) {
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
    for (const Shortcut& row : shortcutTable()) {
        if (row.group != last) {
            last = row.group;
            drawMenu(model, last, actions);
        }
    }
    ImGui::EndMenuBar();
}

bool isAvailable(const PanelModel& model, ActionId id) {
    switch (id) {
        case ActionId::openFile:
        case ActionId::screenshot:
        case ActionId::togglePanels:
        case ActionId::help:
        case ActionId::quit:
            return true;
        case ActionId::undo:
            return model.changes.done > 0;
        case ActionId::redo:
            return model.changes.done < model.changes.rows.size();
        case ActionId::bringDown:
            return model.tools.tool == Tool::guillotine && !model.name.empty();
        case ActionId::freePins:
            return model.pinned > 0;
        case ActionId::loop:
            return model.playback.steps > 0;
        case ActionId::showApart:
            return model.pieces.size() > 1;
        default:
            return !model.name.empty();
    }
}

bool isOn(const PanelModel& model, ActionId id) {
    if (const bool* shown = displaySwitch(model.display, id)) {
        return *shown;
    }
    switch (id) {
        case ActionId::playPause:
            return model.playing;
        case ActionId::toggleGravity:
            return model.params.gravity.norm() > 0;
        case ActionId::showApart:
            return model.display.apart > 0;
        case ActionId::fineQuality:
            return model.display.quality == render::Quality::full;
        case ActionId::toolStroke:
            return model.tools.tool == Tool::stroke;
        case ActionId::toolScalpel:
            return model.tools.tool == Tool::scalpel;
        case ActionId::toolGuillotine:
            return model.tools.tool == Tool::guillotine;
        case ActionId::toolGrab:
            return model.tools.tool == Tool::grab;
        case ActionId::toolPin:
            return model.tools.tool == Tool::pin;
        case ActionId::orthographic:
            return model.orthographic;
        case ActionId::record:
            return model.recording;
        case ActionId::loop:
            return model.playback.loop;
        case ActionId::togglePanels:
            return model.settings.showControls || model.settings.showReadings;
        case ActionId::holdPlots:
            return model.plotView.end.has_value();
        case ActionId::help:
            return model.helpOpen;
        default:
            return false;
    }
}

}  // namespace kerf::ui
