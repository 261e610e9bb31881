#include <imgui.h>

#include "sim/base/text.h"
#include "ui/over_view.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

std::string stateOf(const PanelModel& model) {
    if (model.transport.seeking) {
        return "seeking";
    }
    if (model.transport.stroking) {
        return "cutting";
    }
    if (model.transport.playing) {
        return "playing";
    }
    return model.transport.pulling ? "pulling" : "paused";
}

/// How often pieces ran away and were taken back, where any did.
std::string lossesOf(const PanelModel& model) {
    const auto losses = static_cast<int>((*model.plots.history)[Reading::lostPieces].last());
    return losses > 0 ? ", " + std::to_string(losses) + " reset" : "";
}

}  // namespace

std::string statusText(const PanelModel& model) {
    if (model.name.empty()) {
        return "No file open";
    }
    return model.name + (model.session.unsaved ? " (unsaved)" : "") + "   |   " +
           counted(model.pieces.rows.size(), "piece", "pieces") + lossesOf(model) + "   |   " +
           std::to_string(model.body.vertices) + " vertices, " +
           std::to_string(model.body.triangles) + " triangles   |   " + stateOf(model);
}

namespace {

std::string rightText(const PanelModel& model) {
    const std::string& link = model.view.link;
    return link + (link.empty() ? "" : "   |   ") + model.view.device + "   |   " +
           std::string(keyOf(ActionId::help)) + " help";
}

}  // namespace

void drawStatusBar(const PanelModel& model, const Rect& rect) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    const float padding = (rect.height - ImGui::GetFontSize()) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.6F * padding, padding});
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::TextUnformatted(statusText(model).c_str());
    const std::string right = rightText(model);
    const float width = ImGui::CalcTextSize(right.c_str()).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::TextDisabled("%s", right.c_str());
    ImGui::End();
    ImGui::PopStyleVar(4);
}

}  // namespace kerf::ui
