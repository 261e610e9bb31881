#include "ui/pieces_panel.h"

#include <imgui.h>

#include <string>

#include "ui/widgets.h"

namespace kerf::ui {
namespace {

void drawHeaderRow() {
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("#", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 1.6F);
    ImGui::TableSetupColumn("triangles");
    ImGui::TableSetupColumn("litres");
    ImGui::TableSetupColumn("% of rest");
    ImGui::TableHeadersRow();
}

void drawPieceRow(int index, const PieceRow& piece) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Text("%d", index + 1);
    ImGui::TableNextColumn();
    ImGui::Text("%d", piece.triangles);
    ImGui::TableNextColumn();
    ImGui::Text("%.4g", 1000 * piece.volume);
    ImGui::TableNextColumn();
    ImGui::Text("%.1f", 100 * piece.share);
}

}  // namespace

void drawPieces(const PanelModel& model) {
    sectionTitle(("Pieces: " + std::to_string(model.pieces.size())).c_str());
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                                       ImGuiTableFlags_BordersInnerV |
                                       ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("pieces", 4, kFlags)) {
        return;
    }
    drawHeaderRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(model.pieces.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawPieceRow(i, model.pieces[i]);
        }
    }
    ImGui::EndTable();
}

}  // namespace kerf::ui
