#include "ui/transport_panel.h"

#include <imgui.h>

#include "ui/shortcuts.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

void actionButton(const char* label, ActionId id, float width, std::vector<Action>& actions) {
    if (ImGui::Button(label, {width, 0})) {
        actions.emplace_back(id);
    }
    itemTooltip(describeShortcut(id));
}

void playButton(bool playing, float width, std::vector<Action>& actions) {
    ImGui::PushStyleColor(ImGuiCol_Button,
                          playing ? IM_COL32(50, 59, 72, 255) : IM_COL32(38, 104, 143, 255));
    actionButton(playing ? "Pause###play" : "Play###play", ActionId::playPause, width, actions);
    ImGui::PopStyleColor();
}

}  // namespace

void drawTransport(const PanelModel& model, std::vector<Action>& actions) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    playButton(model.playing, width, actions);
    ImGui::SameLine();
    actionButton("Step", ActionId::stepOnce, width, actions);
    ImGui::SameLine();
    actionButton("Reset", ActionId::reset, width, actions);
    ImGui::TextDisabled("step %d", model.step);
    ImGui::SameLine(width + 2 * gap + ImGui::GetStyle().WindowPadding.x);
    ImGui::TextDisabled("%.3f s", model.time);
    if (!model.playback.empty()) {
        ImGui::TextDisabled("%s", model.playback.c_str());
    }
}

}  // namespace kerf::ui
