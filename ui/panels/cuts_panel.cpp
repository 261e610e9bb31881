#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/base/item_rects.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"

namespace kerf::ui {
namespace {

void drawTitles() {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (const char* title : {"All cuts", "Last"}) {
        ImGui::TableNextColumn();
        textRight(title);
    }
}

void drawRow(const CutRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    textShortened(row.quantity, ImGui::GetContentRegionAvail().x);
    itemTooltip(row.tooltip);
    ImGui::TableNextColumn();
    textRight(row.all);
    noteItem("cuts." + row.quantity);
    ImGui::TableNextColumn();
    textRight(row.last);
}

}  // namespace

void drawCuts(const CutsState& cuts) {
    if (!cuts.note.empty()) {
        ImGui::TextDisabled("%s", cuts.note.c_str());
    }
    if (cuts.rows.empty() ||
        !ImGui::BeginTable("cuts", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    ImGui::TableSetupColumn("quantity", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [title, member] :
         {std::pair{"all cuts", &CutRow::all}, {"last", &CutRow::last}}) {
        float width = ImGui::CalcTextSize(title).x;
        for (const CutRow& row : cuts.rows) {
            width = std::max(width, ImGui::CalcTextSize((row.*member).c_str()).x);
        }
        ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed, width);
    }
    drawTitles();
    for (const CutRow& row : cuts.rows) {
        drawRow(row);
    }
    ImGui::EndTable();
}

}  // namespace kerf::ui
