#include "ui/stages_panel.h"

#include <imgui.h>

namespace kerf::ui {
namespace {

void drawStage(const char* name, double milliseconds) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::Text("%.2f ms", milliseconds);
}

void explainCut(const SubdivisionCounts& counts) {
    if (!ImGui::IsItemHovered()) {
        return;
    }
    ImGui::BeginTooltip();
    ImGui::TextUnformatted("Triangles divided so far");
    for (int i = 0; i < kPaperPatterns; ++i) {
        ImGui::Text("%s: %d", nameOf(static_cast<SubdivisionPattern>(i)), counts[i]);
    }
    ImGui::Text("other: %d", otherPatterns(counts));
    ImGui::EndTooltip();
}

}  // namespace

void drawStages(const StageTimes& stages, const SubdivisionCounts& subdivisions) {
    if (ImGui::BeginTable("stages", 2, ImGuiTableFlags_RowBg)) {
        drawStage("Deform", stages.deform);
        drawStage("Collide", stages.collide);
        drawStage("Cut", stages.cut);
        explainCut(subdivisions);
        drawStage("Frame", stages.frame);
        ImGui::EndTable();
    }
}

}  // namespace kerf::ui
