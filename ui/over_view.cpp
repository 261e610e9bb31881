#include "ui/over_view.h"

#include <imgui.h>

#include "ui/base/theme.h"
#include "ui/state/action_table.h"

namespace kerf::ui {

void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions) {
    const Hint& hint = model.help.hint;
    if (hint.text.empty() || model.transport.stroking || model.help.open) {
        return;
    }
    const float line = ImGui::GetFontSize();
    const float y = view.y + view.height - 2 * line;
    if (!hint.choices.empty()) {
        drawOffer("hint", hint, view, y + line / 2, {.accent = palette().blade, .opacity = 1},
                  actions);
        return;
    }
    drawBanner("hint", hint.text, view.x + view.width / 2, y, view.width,
               {.accent = palette().blade, .opacity = 1});
}

void drawPanelsHint(const Settings& settings, const Rect& view, std::vector<Action>& actions) {
    if (settings.showsPanels()) {
        return;
    }
    const std::string label = "Show panels   " + std::string(keyOf(ActionId::togglePanels));
    const Rect place{view.x + bannerPadding(), view.y + bannerPadding(), buttonWidth(label),
                     ImGui::GetFrameHeight()};
    beginBanner("panels", place, {.opacity = 1});
    endBanner();
    beginControl("panels.show", place);
    if (button(label.c_str(), "panels.show", "Show the menu and the panels")) {
        actions.emplace_back(ActionId::togglePanels);
    }
    endControl();
}

void drawToast(const ToastState& toast, const Rect& view, std::vector<Action>& actions) {
    if (toast.text.empty()) {
        return;
    }
    const float line = ImGui::GetFontSize();
    const BannerStyle style{.accent = palette().of(toast.isError ? Hue::vermillion : Hue::blue),
                            .opacity = toast.opacity};
    if (toast.choice) {
        drawOffer("toast", {toast.text, {*toast.choice}}, view, view.y + 5 * line, style, actions);
    } else {
        drawBanner("toast", toast.text, view.x + view.width / 2, view.y + 2.5F * line, view.width,
                   style);
    }
}

namespace {

/// A button that names its key behind what it does.
class ChoiceButton {
  public:
    explicit ChoiceButton(const HintChoice& choice)
        : id_(choice.id), label_(choice.label), key_(keyOf(choice.id)) {}

    float width() const {
        return buttonWidth(label_) + gap() + ImGui::CalcTextSize(key_.c_str()).x;
    }
    void draw(const char* offer, const ImVec2& low, std::vector<Action>& actions) const {
        const std::string name = std::string(offer) + "." + key_;
        beginControl(name, {low.x, low.y, width(), ImGui::GetFrameHeight()});
        if (button(("##" + key_).c_str(), name, "", width())) {
            actions.emplace_back(id_);
        }
        const ImVec2 padding = ImGui::GetStyle().FramePadding;
        const ImVec2 at{low.x + padding.x, low.y + padding.y};
        const float behind = ImGui::CalcTextSize(label_.c_str()).x + gap();
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.AddText(at, palette().text, label_.c_str());
        draw.AddText({at.x + behind, at.y}, palette().dimText, key_.c_str());
        endControl();
    }

  private:
    static float gap() { return 0.6F * ImGui::GetFontSize(); }

    ActionId id_;
    std::string label_;
    std::string key_;
};

/// The buttons one behind the other, in as many lines as they need.
class ButtonLines {
  public:
    ButtonLines(const std::vector<HintChoice>& choices, float most) {
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        float end = 0;
        for (const HintChoice& choice : choices) {
            const ChoiceButton button(choice);
            const bool first = lines_.empty() || end + gap + button.width() > most;
            end = first ? button.width() : end + gap + button.width();
            if (first) {
                lines_.emplace_back();
            }
            lines_.back().push_back(button);
            width_ = std::max(width_, end);
        }
    }
    float width() const { return width_; }
    float height() const {
        return static_cast<float>(lines_.size()) * ImGui::GetFrameHeightWithSpacing();
    }
    void draw(const char* offer, const ImVec2& low, std::vector<Action>& actions) const {
        ImVec2 at = low;
        for (const std::vector<ChoiceButton>& line : lines_) {
            for (const ChoiceButton& button : line) {
                button.draw(offer, at, actions);
                at.x += button.width() + ImGui::GetStyle().ItemSpacing.x;
            }
            at = {low.x, at.y + ImGui::GetFrameHeightWithSpacing()};
        }
    }

  private:
    std::vector<std::vector<ChoiceButton>> lines_;
    float width_ = 0;
};

}  // namespace

void drawOffer(const char* name, const Hint& hint, const Rect& view, float bottom,
               const BannerStyle& style, std::vector<Action>& actions) {
    const float most = view.width - 2 * bannerPadding();
    const std::string lines = wrapped(hint.text, most);
    const ImVec2 text = ImGui::CalcTextSize(lines.c_str());
    const ButtonLines buttons(hint.choices, most);
    const float width = std::max(text.x, std::min(buttons.width(), most));
    const float height = text.y + buttons.height();
    beginBanner(name, {view.x + (view.width - width) / 2, bottom - height, width, height}, style);
    ImGui::TextUnformatted(lines.c_str());
    const ImVec2 below = ImGui::GetCursorScreenPos();
    endBanner();
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, style.opacity);
    buttons.draw(name, below, actions);
    ImGui::PopStyleVar();
}

}  // namespace kerf::ui
