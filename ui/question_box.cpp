#include "ui/question_box.h"

#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "ui/base/panel_context.h"
#include "ui/base/widgets.h"

namespace kerf::ui {
namespace {

constexpr char kQuestionWindow[] = "###question";

void drawChoices(const Question& question, double number, std::vector<Action>& actions) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = -style.ItemSpacing.x;
    for (const std::string& choice : question.choices) {
        width += buttonWidth(choice) + style.ItemSpacing.x;
    }
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    for (std::size_t i = question.choices.size(); i-- > 0;) {
        const ImGuiCol color = i == 0 ? ImGuiCol_ButtonActive : ImGuiCol_Button;  // 0: Enter's
        ImGui::PushStyleColor(ImGuiCol_Button, style.Colors[color]);
        if (button(question.choices[i].c_str(), "question." + std::to_string(i))) {
            actions.emplace_back(AnswerQuestion{static_cast<int>(i), number});
        }
        ImGui::PopStyleColor();
        if (i > 0) {
            ImGui::SameLine();
        }
    }
}

bool beginInMiddle(const std::string& title, bool wanted) {
    const float display = ImGui::GetIO().DisplaySize.x;
    return beginModal(title, std::min(34 * ImGui::GetFontSize(), 0.9F * display), 0, wanted);
}

}  // namespace

void QuestionBox::drawPicture() {
    const float most = ImGui::GetContentRegionAvail().x;
    const auto width = static_cast<float>(picture_.width());
    const auto height = static_cast<float>(picture_.height());
    const float scale = std::min(1.0F, most / width);
    ImGui::Image(idOf(picture_), {scale * width, scale * height});
    noteItem("question.picture");
    ImGui::Spacing();
}

void QuestionBox::drawNumber(const AskedNumber& asked) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(asked.label.c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(9 * ImGui::GetFontSize());
    dragNumbers({&number_, 1},
                {ImGuiDataType_Double, nullptr, &asked.least, &asked.most, "%.4g " + asked.unit},
                kTypedOnly);
    noteItem("question.number");
    itemTooltip(fmt::format("From {:.3g} to {:.3g}", asked.least, asked.most));
    ImGui::Spacing();
}

bool QuestionBox::leavesOpen(float x, float y) const {
    const bool inside = x >= place_.x && x < place_.x + place_.width && y >= place_.y &&
                        y < place_.y + place_.height;
    return open_ && aside_ && !inside;
}

void QuestionBox::draw(const Question& question, const Rect& view, std::vector<Action>& actions) {
    const bool wanted = !question.text.empty();
    const bool justOpened = wanted && !open_;
    const bool wasOpen = std::exchange(open_, wanted);
    if (!wanted && !wasOpen) {
        return;
    }
    if (justOpened) {
        picture_ = question.picture ? textureOf(*question.picture) : gpu::Texture();
        number_ = question.number ? question.number->value : 0;
        ImGui::OpenPopup(kQuestionWindow);
    }
    aside_ = question.aside;
    const std::string title = question.title + kQuestionWindow;
    if (!(aside_ ? beginModalAside(title, view, wanted) : beginInMiddle(title, wanted))) {
        return;
    }
    const ImVec2 at = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    place_ = {at.x, at.y, size.x, size.y};
    if (picture_.id() != 0) {
        drawPicture();
    }
    textWrapped(question.text);
    ImGui::Spacing();
    if (question.number) {
        drawNumber(*question.number);
    }
    drawChoices(question, number_, actions);
    if (!justOpened && keyPressed(ImGuiKey_Enter) && !refusedNumber()) {
        actions.emplace_back(AnswerQuestion{0, number_});
    } else if (!justOpened && keyPressed(ImGuiKey_Escape)) {
        actions.emplace_back(AnswerQuestion{static_cast<int>(question.choices.size()) - 1});
    }
    ImGui::EndPopup();
}

}  // namespace kerf::ui
