#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "ui/base/theme.h"
#include "ui/over_view.h"

namespace kerf::ui {
namespace {

/// A light that runs to and fro: how much is left is not known.
void drawRunner(double seconds) {
    constexpr float kShare = 0.25F;
    constexpr double kPeriod = 2.4;  // [s]
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = std::floor(0.3F * ImGui::GetFontSize());
    const auto phase = static_cast<float>(std::fmod(seconds / kPeriod, 1.0));
    const float x = low.x + (1 - kShare) * width * (1 - std::abs(2 * phase - 1));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + width, low.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                       height / 2);
    draw.AddRectFilled({x, low.y}, {x + kShare * width, low.y + height}, palette().blade,
                       height / 2);
    ImGui::Dummy({width, height});
}

void drawCancel(const ImVec2& place, std::vector<Action>& actions) {
    beginControl("work.cancel", {place.x, place.y, buttonWidth("Cancel"), ImGui::GetFrameHeight()});
    if (button("Cancel", "work.cancel")) {
        actions.emplace_back(CancelWork{});
    }
    endControl();
}

}  // namespace

std::string timeText(const WorkState& work) {
    constexpr double kMinute = 60;
    if (!work.left) {
        return work.seconds < 1 ? "" : fmt::format(", {:.0f} s so far", work.seconds);
    }
    if (*work.left < 1) {
        return ", almost done";
    }
    if (*work.left < 2 * kMinute) {
        const double step = *work.left < 10 ? 1 : 5;
        return fmt::format(", about {:.0f} s left", step * std::ceil(*work.left / step));
    }
    return fmt::format(", about {:.0f} min left", *work.left / kMinute);
}

void drawWork(const WorkState& work, const Rect& view, std::vector<Action>& actions) {
    if (work.title.empty()) {
        return;
    }
    const float line = ImGui::GetFontSize();
    const float width = std::min(view.width, 26 * line);
    ImGui::SetNextWindowPos({view.x + (view.width - width) / 2, view.y + 4.5F * line});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("work", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs);
    ImGui::TextUnformatted(work.title.c_str());
    if (work.all > 0) {
        const double share = std::min(1.0, work.done / work.all);
        ImGui::ProgressBar(static_cast<float>(share), {-1, 0.3F * line}, "");
    } else {
        drawRunner(work.seconds);
    }
    ImGui::AlignTextToFramePadding();
    if (work.mayEnd) {
        ImGui::TextDisabled("%s%s", work.stage.c_str(), timeText(work).c_str());
    } else {
        ImGui::TextDisabled("%s", work.stage.c_str());
    }
    const ImVec2 end = ImGui::GetItemRectMin();
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    ImGui::End();
    if (work.mayEnd) {
        drawCancel({right - buttonWidth("Cancel"), end.y - ImGui::GetStyle().FramePadding.y},
                   actions);
    }
}

}  // namespace kerf::ui
