#include <imgui.h>
#include <imgui_internal.h>

#include <sstream>

#include "ui/base/layout.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

/// Lines through points in percent of a square, from its upper left corner. After its points a line
/// is drawn open (-), closed (o) or filled (*).
struct Icon {
    ActionId id;
    const char* lines;
};
constexpr const char* kCamera =
    "5 28 33 28 40 14 60 14 67 28 95 28 95 85 5 85 o 50 40 63 46 66 57 60 68 50 72 40 68 34 57 "
    "37 46 o";
constexpr std::array kIcons{
    Icon{ActionId::openFile, "5 20 40 20 50 32 95 32 95 85 5 85 o"},
    Icon{ActionId::addModel, "50 12 50 88 - 12 50 88 50 -"},
    Icon{ActionId::saveSession,
         "10 10 75 10 90 25 90 90 10 90 o 30 10 30 36 65 36 65 10 - "
         "26 90 26 60 74 60 74 90 -"},
    Icon{ActionId::exportBody, "12 55 12 90 88 90 88 55 - 50 70 50 12 - 27 35 50 12 73 35 -"},
    Icon{ActionId::makeFilm, "5 25 66 25 66 78 5 78 o 70 52 98 28 98 76 *"},
    Icon{ActionId::screenshot, kCamera},
    Icon{ActionId::quit, "18 18 82 82 - 82 18 18 82 -"},
    Icon{ActionId::undo, "25 42 60 42 80 52 84 66 78 82 60 90 40 90 - 2 42 34 20 34 64 *"},
    Icon{ActionId::redo, "75 42 40 42 20 52 16 66 22 82 40 90 60 90 - 98 42 66 64 66 20 *"},
    Icon{ActionId::toggleGravity, "50 8 50 65 - 22 60 78 60 50 94 *"},
    Icon{ActionId::playPause, "20 10 90 50 20 90 *"},
    Icon{ActionId::stepOnce, "12 12 70 50 12 88 * 82 12 82 88 -"},
    Icon{ActionId::reset, "88 12 88 88 30 50 * 18 12 18 88 -"},
    Icon{ActionId::record, "50 12 77 23 88 50 77 77 50 88 23 77 12 50 23 23 *"},
    Icon{ActionId::addCamera, kCamera},
    Icon{ActionId::frameBody,
         "10 35 10 10 35 10 - 65 10 90 10 90 35 - 90 65 90 90 65 90 - "
         "35 90 10 90 10 65 -"},
    Icon{ActionId::resetView, "5 52 50 12 95 52 - 20 42 20 90 80 90 80 42 -"},
    Icon{ActionId::manual, "15 10 85 10 85 90 15 90 o 32 10 32 90 -"},
    Icon{ActionId::about,
         "50 8 80 20 92 50 80 80 50 92 20 80 8 50 20 20 o 50 44 50 74 - "
         "50 24 50 34 -"},
};

/// Into a square from `low` on [px], where the action has an icon.
void drawIcon(ActionId id, const ImVec2& low, float side, ImU32 color) {
    const auto* const icon = std::ranges::find(kIcons, id, &Icon::id);
    std::istringstream words(icon == kIcons.end() ? "" : icon->lines);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::string x; words >> x;) {
        float y = 0;
        if (x == "*") {
            draw.PathFillConvex(color);
        } else if (x == "-" || x == "o") {
            draw.PathStroke(color, x == "o" ? ImDrawFlags_Closed : ImDrawFlags_None, 0.1F * side);
        } else if (words >> y) {
            draw.PathLineTo({low.x + std::stof(x) * side / 100, low.y + y * side / 100});
        }
    }
}

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
