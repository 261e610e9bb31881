#include "ui/base/layout.h"

#include <imgui.h>

namespace kerf::ui {

namespace {

ItemRects* rectsNow = nullptr;

/// An item that panels have still to show, and the last update in which they look for it.
std::string sought;
int soughtUntil = 0;

}  // namespace

Layout layoutPanels(float width, float height, float scale, const Settings& settings,
                    bool withTimeline) {
    constexpr float kMargin = 8;
    constexpr float kStatusHeight = 28;
    constexpr float kTimelineHeight = 34;
    const float margin = kMargin * scale;
    const float status = kStatusHeight * scale;
    const float timeline = withTimeline ? kTimelineHeight * scale : 0;
    const float panelHeight = std::max(1.0F, height - status - timeline - 2 * margin);
    const auto side = [&](bool shown, double wanted) {
        return shown ? std::min(static_cast<float>(wanted) * scale, width / 3 - margin) : 0;
    };
    const float left = side(settings.showControls, settings.controlsWidth);
    const float right = side(settings.showReadings, settings.readingsWidth);
    const float leftEnd = left > 0 ? margin + left : 0;
    const float rightStart = right > 0 ? width - margin - right : width;

    Layout layout;
    layout.controls = {margin, margin, left, panelHeight};
    layout.plots = {width - margin - right, margin, right, panelHeight};
    layout.timeline = {0, height - status - timeline, width, timeline};
    layout.status = {0, height - status, width, status};
    layout.controlsEdge = {leftEnd, margin, margin, panelHeight};
    layout.plotsEdge = {rightStart - margin, margin, margin, panelHeight};
    layout.view = {leftEnd + margin, margin, rightStart - leftEnd - 2 * margin, panelHeight};
    return layout;
}

float largestScale(int width, int height) {
    constexpr float kStep = 0.25F;
    const float room = std::min(static_cast<float>(width) / kLeastWidth,
                                static_cast<float>(height) / kLeastHeight);
    return std::max(kLeastScale, std::floor(room / kStep) * kStep);
}

ItemNotes::ItemNotes(ItemRects& rects) {
    rects.clear();
    rectsNow = &rects;
}

ItemNotes::~ItemNotes() {
    rectsNow = nullptr;
}

void noteItem(const std::string& name) {
    if (rectsNow != nullptr) {
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 size = ImGui::GetItemRectSize();
        (*rectsNow)[name] = {low.x, low.y, size.x, size.y};
    }
    if (name.ends_with(".number") && isSought(name.substr(0, name.rfind('.')))) {
        ImGui::SetKeyboardFocusHere(-1);
    } else if (isSought(name)) {
        ImGui::SetScrollHereY();
        sought.clear();
    }
}

void seekItem(const std::string& name) {
    constexpr int kUpdates = 10;  // until its section is unfolded
    sought = name;
    soughtUntil = ImGui::GetFrameCount() + kUpdates;
}

bool isSought(std::string_view name) {
    return !name.empty() && name == sought && ImGui::GetFrameCount() <= soughtUntil &&
           !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
}

}  // namespace kerf::ui
