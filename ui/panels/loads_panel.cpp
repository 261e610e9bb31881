#include <imgui.h>

#include "sim/base/text.h"
#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

constexpr std::size_t kMostRows = 8;  // without scrolling

/// True while the pointer is on the row. It takes the pointer as a whole, the button on top of it.
bool drawRow(int index, const LoadsState& loads, std::vector<Action>& actions) {
    const LoadRow& load = loads.rows[static_cast<std::size_t>(index)];
    const bool selected = index == loads.selected;
    const std::string text =
        std::string(load.kind) + ", " + counted(load.vertices, "vertex", "vertices");
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(index);
    if (ImGui::Selectable(
            text.c_str(), selected,
            ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap)) {
        actions.emplace_back(SelectLoad{selected ? -1 : index});
    }
    describeItem("load." + std::to_string(index), load.detail);
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenOverlapped |
                                              ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(load.value.c_str());
    ImGui::TableNextColumn();
    if (smallButton("\u00d7", "load.remove." + std::to_string(index), "Remove from the body")) {
        actions.emplace_back(RemoveLoad{static_cast<std::size_t>(index)});
    }
    ImGui::PopID();
    return hovered;
}

}  // namespace

void drawLoads(const LoadsState& loads, std::vector<Action>& actions) {
    const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    const auto shown = static_cast<float>(std::min(loads.rows.size(), kMostRows));
    int hovered = -1;
    if (ImGui::BeginTable("loads", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY,
                          {0, shown * line + 2})) {
        ImGui::TableSetupColumn("load", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed);
        ImGui::TableSetupColumn("remove", ImGuiTableColumnFlags_WidthFixed);
        for (int i = 0; i < static_cast<int>(loads.rows.size()); ++i) {
            hovered = drawRow(i, loads, actions) ? i : hovered;
        }
        ImGui::EndTable();
    }
    if (hovered != loads.hovered) {
        actions.emplace_back(HoverLoad{hovered});
    }
}

}  // namespace kerf::ui
