#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"
#include "ui/base/layout.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

void actionButton(const char* label, ActionId id, float width, std::vector<Action>& actions) {
    if (button(label, "button." + std::string(rowOf(id).label), describeAction(id), width)) {
        actions.emplace_back(id);
    }
}

void playButton(bool playing, float width, std::vector<Action>& actions) {
    if (!playing) {
        ImGui::PushStyleColor(ImGuiCol_Button, palette().primary);
        ImGui::PushStyleColor(ImGuiCol_Text, palette().primaryText);
    }
    actionButton(playing ? "Pause###play" : "Play###play", ActionId::playPause, width, actions);
    if (!playing) {
        ImGui::PopStyleColor(2);
    }
}

void recordButton(bool recording, float width, std::vector<Action>& actions) {
    if (recording) {
        ImGui::PushStyleColor(ImGuiCol_Button, palette().of(Hue::vermillion));
    }
    actionButton(recording ? "Stop###record" : "Record###record", ActionId::record, width, actions);
    if (recording) {
        ImGui::PopStyleColor();
    }
}

void drawLoop(const PlaybackState& playback, std::vector<Action>& actions) {
    bool loop = playback.loop;
    if (checkbox("Loop", loop, "loop", describeAction(ActionId::loop))) {
        actions.emplace_back(ActionId::loop);
    }
}

/// Pictures, checks and exports of this step.
void drawAddButton(float width, std::vector<Action>& actions) {
    if (button("Add \u25be", "session.add",
               "Add a picture, a check, an export or a camera keyframe at this step", width)) {
        ImGui::OpenPopup("add");
    }
    placePopupBelowItem();
    if (ImGui::BeginPopup("add")) {
        drawSessionAdditions(actions);
        ImGui::EndPopup();
    }
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
    itemTooltip("Wanted speed of time (- and =), as far as the computer keeps up");
}

/// What steps were chosen, and what the clock went to.
std::string explainPace(const PanelModel& model) {
    const Params& params = model.parameters.now;
    return fmt::format(
        "Real-time factor: simulated seconds over seconds of the clock.\n"
        "Step {:.3g} ms, {}{}.\n{}",
        1000 * params.timeStep, partsOfStep(model.parameters),
        params.iterations == kAutoIterations ? " (auto)" : "",
        sharesOfStages(*model.plots.history));
}

void drawPace(const PanelModel& model) {
    const TransportState& transport = model.transport;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", transport.realTimeFactor
                                  ? (factorText(*transport.realTimeFactor) + " real time").c_str()
                                  : "real time: not run yet");
    noteItem("transport.pace");
    if (ImGui::IsItemHovered()) {
        itemTooltip(explainPace(model));
    }
}

/// In a narrow panel words need the room more than what is around them.
void drawTransportButtons(const TransportState& transport, std::vector<Action>& actions) {
    constexpr std::array kWords{"Pause", "Step", "Restart", "Record"};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    float around = ImGui::GetContentRegionAvail().x - (kWords.size() - 1) * gap;
    for (const char* word : kWords) {
        around -= ImGui::CalcTextSize(word).x;
    }
    const auto width = [&](std::size_t i) {
        return ImGui::CalcTextSize(kWords[i]).x + around / kWords.size();
    };
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
    playButton(transport.playing, width(0), actions);
    ImGui::SameLine(0, gap);
    actionButton("Step", ActionId::stepOnce, width(1), actions);
    ImGui::SameLine(0, gap);
    actionButton("Restart", ActionId::reset, width(2), actions);
    ImGui::SameLine(0, gap);
    recordButton(transport.recording, width(3), actions);
    ImGui::PopStyleVar();
}

}  // namespace

void drawTransport(const PanelModel& model, std::vector<Action>& actions) {
    const TransportState& transport = model.transport;
    const PlaybackState& playback = model.session.playback;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 3 * gap) / 4;
    drawTransportButtons(transport, actions);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("step %d, %.3f s%s", transport.step, transport.time,
                        transport.restarted ? " since restart" : "");
    ImGui::SameLine(3 * (width + gap) + ImGui::GetStyle().WindowPadding.x);
    ImGui::SetNextItemWidth(width);
    drawSpeed(transport.speed, actions);
    drawPace(model);
    const bool played = playback.played;
    if (played || transport.recording) {
        drawAddButton(width, actions);
    }
    if (played) {
        ImGui::SameLine();
        drawLoop(playback, actions);
    }
}

}  // namespace kerf::ui
