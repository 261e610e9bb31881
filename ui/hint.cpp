#include "ui/hint.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "ui/action_table.h"
#include "ui/item_rects.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

/// A button that names its key behind what it does.
class ChoiceButton {
  public:
    explicit ChoiceButton(const HintChoice& choice)
        : id_(choice.id), label_(choice.label), key_(keyOf(choice.id)) {}

    float width() const {
        return buttonWidth(label_) + gap() + ImGui::CalcTextSize(key_.c_str()).x;
    }
    void draw(std::vector<Action>& actions) const {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        if (ImGui::Button(("##" + key_).c_str(), {width(), 0})) {
            actions.emplace_back(id_);
        }
        noteItem("hint." + key_);
        const ImVec2 padding = ImGui::GetStyle().FramePadding;
        const ImVec2 at{low.x + padding.x, low.y + padding.y};
        const float behind = ImGui::CalcTextSize(label_.c_str()).x + gap();
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.AddText(at, palette().text, label_.c_str());
        draw.AddText({at.x + behind, at.y}, palette().dimText, key_.c_str());
    }

  private:
    static float gap() { return 0.6F * ImGui::GetFontSize(); }

    ActionId id_;
    std::string label_;
    std::string key_;
};

float widthOf(const std::vector<HintChoice>& choices) {
    float width = -ImGui::GetStyle().ItemSpacing.x;
    for (const HintChoice& choice : choices) {
        width += ChoiceButton(choice).width() + ImGui::GetStyle().ItemSpacing.x;
    }
    return width;
}

/// The sentence above a row of buttons, in the middle of `view` and down to `bottom` [px].
void drawOffer(const Hint& hint, const Rect& view, float bottom, std::vector<Action>& actions) {
    const float most = view.width - 2 * bannerPadding();
    const ImVec2 text = ImGui::CalcTextSize(hint.text.c_str(), nullptr, false, most);
    const float width = std::max(text.x, std::min(widthOf(hint.choices), most));
    const float height = text.y + ImGui::GetStyle().ItemSpacing.y + ImGui::GetFrameHeight();
    beginBanner("hint", {view.x + (view.width - width) / 2, bottom - height, width, height},
                {.accent = palette().blade, .opacity = 1, .takesInput = true});
    ImGui::PushTextWrapPos(bannerPadding() + width + 1);
    ImGui::TextUnformatted(hint.text.c_str());
    ImGui::PopTextWrapPos();
    for (std::size_t i = 0; i < hint.choices.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine();
        }
        ChoiceButton(hint.choices[i]).draw(actions);
    }
    endBanner();
}

}  // namespace

void drawHint(const PanelModel& model, const Rect& view, std::vector<Action>& actions) {
    const Hint& hint = model.hint;
    if (hint.text.empty() || model.stroking || model.helpOpen) {
        return;
    }
    const float line = ImGui::GetFontSize();
    const float y = model.name.empty() ? view.y + view.height / 2 : view.y + view.height - 2 * line;
    if (!hint.choices.empty()) {
        drawOffer(hint, view, y + line / 2, actions);
        return;
    }
    drawBanner("hint", hint.text, view.x + view.width / 2, y, view.width,
               {.accent = palette().blade, .opacity = 1});
}

}  // namespace kerf::ui
