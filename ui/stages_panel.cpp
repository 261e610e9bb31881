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

}  // namespace

void drawStages(const StageTimes& stages) {
    if (ImGui::BeginTable("stages", 2, ImGuiTableFlags_RowBg)) {
        drawStage("Deform", stages.deform);
        drawStage("Collide", stages.collide);
        drawStage("Cut", stages.cut);
        drawStage("Frame", stages.frame);
        ImGui::EndTable();
    }
}

}  // namespace kerf::ui
