#include "ui/offer.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "ui/action_table.h"
#include "ui/item_rects.h"
#include "ui/theme.h"

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
    void draw(const char* offer, std::vector<Action>& actions) const {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        if (ImGui::Button(("##" + key_).c_str(), {width(), 0})) {
            actions.emplace_back(id_);
        }
        noteItem(std::string(offer) + "." + key_);
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

}  // namespace

void drawOffer(const char* name, const Hint& hint, const Rect& view, float bottom,
               const BannerStyle& style, std::vector<Action>& actions) {
    const float most = view.width - 2 * bannerPadding();
    const ImVec2 text = ImGui::CalcTextSize(hint.text.c_str(), nullptr, false, most);
    const float width = std::max(text.x, std::min(widthOf(hint.choices), most));
    const float height = text.y + ImGui::GetStyle().ItemSpacing.y + ImGui::GetFrameHeight();
    beginBanner(name, {view.x + (view.width - width) / 2, bottom - height, width, height}, style);
    ImGui::PushTextWrapPos(bannerPadding() + width + 1);
    ImGui::TextUnformatted(hint.text.c_str());
    ImGui::PopTextWrapPos();
    for (std::size_t i = 0; i < hint.choices.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine();
        }
        ChoiceButton(hint.choices[i]).draw(name, actions);
    }
    endBanner();
}

}  // namespace kerf::ui
