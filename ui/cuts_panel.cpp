#include "ui/cuts_panel.h"

#include <imgui.h>

#include "ui/item_rects.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

void drawTitles() {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    for (const char* title : {"all cuts", "last"}) {
        ImGui::TableNextColumn();
        textRight(title);
    }
}

void drawRow(const CutRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.quantity.c_str());
    itemTooltip(row.tooltip);
    ImGui::TableNextColumn();
    textRight(row.all);
    noteItem("cuts." + row.quantity);
    ImGui::TableNextColumn();
    textRight(row.last);
}

}  // namespace

void drawCuts(const PanelModel& model) {
    if (!model.cuts.note.empty()) {
        ImGui::TextDisabled("%s", model.cuts.note.c_str());
    }
    if (model.cuts.rows.empty() ||
        !ImGui::BeginTable("cuts", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
        return;
    }
    drawTitles();
    for (const CutRow& row : model.cuts.rows) {
        drawRow(row);
    }
    ImGui::EndTable();
}

}  // namespace kerf::ui
