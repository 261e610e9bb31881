#include "ui/transport_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/item_places.h"
#include "ui/shortcuts.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

void actionButton(const char* label, ActionId id, float width, std::vector<Action>& actions) {
    if (ImGui::Button(label, {width, 0})) {
        actions.emplace_back(id);
    }
    noteItem("button." + std::string(shortcutOf(id).label));
    itemTooltip(describeShortcut(id));
}

void playButton(bool playing, float width, std::vector<Action>& actions) {
    ImGui::PushStyleColor(ImGuiCol_Button,
                          playing ? IM_COL32(50, 59, 72, 255) : IM_COL32(38, 104, 143, 255));
    actionButton(playing ? "Pause###play" : "Play###play", ActionId::playPause, width, actions);
    ImGui::PopStyleColor();
}

void drawSpeed(double speed, std::vector<Action>& actions) {
    static constexpr std::array<std::pair<double, const char*>, 5> kSpeeds{{{0.25, "\u00bc\u00d7"},
                                                                            {0.5, "\u00bd\u00d7"},
                                                                            {1, "1\u00d7"},
                                                                            {2, "2\u00d7"},
                                                                            {4, "4\u00d7"}}};
    const auto* now = std::ranges::find(kSpeeds, speed, &std::pair<double, const char*>::first);
    if (ImGui::BeginCombo("##speed", now == kSpeeds.end() ? "" : now->second)) {
        for (const auto& [factor, label] : kSpeeds) {
            if (ImGui::Selectable(label, factor == speed)) {
                actions.emplace_back(SetSpeed{factor});
            }
        }
        ImGui::EndCombo();
    }
    itemTooltip("Speed of time against the clock (- and =), where the computer keeps up");
}

}  // namespace

void drawTransport(const PanelModel& model, std::vector<Action>& actions) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    playButton(model.playing, width, actions);
    ImGui::SameLine();
    actionButton("Step", ActionId::stepOnce, width, actions);
    ImGui::SameLine();
    actionButton("Restart", ActionId::reset, width, actions);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("step %d, %.3f s", model.step, model.time);
    ImGui::SameLine(2 * (width + gap) + ImGui::GetStyle().WindowPadding.x);
    ImGui::SetNextItemWidth(width);
    drawSpeed(model.speed, actions);
    if (!model.playback.empty()) {
        ImGui::TextDisabled("%s", model.playback.c_str());
    }
}

}  // namespace kerf::ui
