#include <imgui.h>

#include "ui/base/theme.h"
#include "ui/over_view.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr const char* kMouse = "Mouse";
constexpr int kMostColumns = 3;
constexpr float kColumnWidth = 27;  // in letters' heights
constexpr float kGestureWidth = 14.5F;
constexpr float kKeysWidth = 10;

/// The rows under one heading.
struct Group {
    std::string title;
    std::vector<PointerHint> rows;
};

void addRow(std::vector<Group>& groups, std::string_view title, const PointerHint& row) {
    if (groups.empty() || groups.back().title != title) {
        groups.push_back({std::string(title), {}});
    }
    groups.back().rows.push_back(row);
}

std::vector<Group> allGroups(MouseScheme mouse) {
    std::vector<Group> groups;
    for (const PointerHint& row : pointerTable(mouse)) {
        addRow(groups, kMouse, row);
    }
    for (const ActionRow& row : actionTable()) {
        if (!row.shortcut.text.empty()) {
            addRow(groups, row.group, {keysOf(row.id), row.label});
        }
    }
    return groups;
}

void drawGroup(const Group& group) {
    ImGui::TextDisabled("%s", group.title.c_str());
    if (!ImGui::BeginTable(group.title.c_str(), 2, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    ImGui::TableSetupColumn(
        "keys", ImGuiTableColumnFlags_WidthFixed,
        (group.title == kMouse ? kGestureWidth : kKeysWidth) * ImGui::GetFontSize());
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch);
    for (const PointerHint& row : group.rows) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, palette().of(Hue::blue));
        textWrapped(row.gesture);
        ImGui::PopStyleColor();
        ImGui::TableNextColumn();
        textWrapped(row.label);
    }
    ImGui::EndTable();
    ImGui::Spacing();
}

/// The groups in their order, in columns of about the same length.
void drawGroups(const std::vector<Group>& groups, int columns) {
    std::size_t all = 0;
    for (const Group& group : groups) {
        all += group.rows.size() + 1;
    }
    if (!ImGui::BeginTable("help", columns, ImGuiTableFlags_SizingStretchSame)) {
        return;
    }
    ImGui::TableNextColumn();
    std::size_t length = 0;
    int column = 1;
    for (const Group& group : groups) {
        const std::size_t rows = group.rows.size() + 1;
        if (column < columns && columns * (length + rows / 2) > all) {
            ImGui::TableNextColumn();
            ++column;
            length = 0;
        }
        drawGroup(group);
        length += rows;
    }
    ImGui::EndTable();
}

}  // namespace

void drawHelp(const PanelModel& model, std::vector<Action>& actions) {
    if (!model.help.open) {
        return;
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float column = kColumnWidth * ImGui::GetFontSize();
    const float most = 0.96F * display.x;
    const int columns = std::clamp(static_cast<int>(most / column), 1, kMostColumns);
    const float width = std::min(most, static_cast<float>(columns) * column);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, 0.96F * display.y});
    ImGui::SetNextWindowBgAlpha(0.985F);  // What lies below must not shine through the letters.
    ImGui::Begin("Keyboard shortcuts", nullptr,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {4, 2});
    drawGroups(allGroups(model.settings.mouse), columns);
    ImGui::PopStyleVar();
    if (button("Close", "help.close")) {
        actions.emplace_back(ActionId::help);
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("or Esc");
    ImGui::End();
}

}  // namespace kerf::ui
