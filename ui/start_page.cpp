#include "ui/start_page.h"

#include <imgui.h>

#include <cstdlib>

#include "ui/base/panel_context.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr int kCardColumns = 7;
constexpr float kLeastCard = 7;          // the width of one, in lines
constexpr float kPictureShape = 0.625F;  // height over width

void drawText(const ImVec2& at, ImU32 color, const std::string& text, float wrap = 0) {
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, color,
                                        text.c_str(), nullptr, wrap);
}

std::string folderText(const std::filesystem::path& file) {
    std::string folder = file.parent_path().string() + "/";
    const char* const home = std::getenv("HOME");
    if (home != nullptr && *home != '\0' && folder.starts_with(std::string(home) + "/")) {
        folder.replace(0, std::string(home).size(), "~");
    }
    return folder;
}

/// The nearest item in a direction, or the same where there is none.
std::size_t nextItem(const std::vector<Rect>& items, std::size_t from, float right, float down) {
    float least = std::numeric_limits<float>::max();
    std::size_t found = from;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const float x = items[i].x - items[from].x;
        const float y = items[i].y - items[from].y;
        const float along = right * x + down * y;
        const float far = along + 2 * (std::abs(right * y) + std::abs(down * x));
        if (along > 1 && far < least) {
            least = far;
            found = i;
        }
    }
    return found;
}

void drawPlus(const ImVec2& middle, float radius) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = palette().of(Hue::blue);
    const float arm = 0.45F * radius;
    draw.AddCircle(middle, radius, color, 0, radius / 9);
    draw.AddLine({middle.x - arm, middle.y}, {middle.x + arm, middle.y}, color, radius / 9);
    draw.AddLine({middle.x, middle.y - arm}, {middle.x, middle.y + arm}, color, radius / 9);
}

float heightOf(const std::string& text, float wrap) {
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap).y;
}

/// Over the picture of a card that was chosen, at once.
void drawOpening(const ImVec2& low, const ImVec2& high) {
    const ImVec2 size = ImGui::CalcTextSize("Opening...");
    const float line = ImGui::GetFontSize();
    const ImVec2 at{(low.x + high.x - size.x) / 2, (low.y + high.y - size.y) / 2};
    ImGui::GetWindowDrawList()->AddRectFilled({at.x - line / 2, at.y - line / 3},
                                              {at.x + size.x + line / 2, at.y + size.y + line / 3},
                                              palette().of(Hue::blue), line / 3);
    drawText(at, IM_COL32_WHITE, "Opening...");
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy(size);
    noteItem("start.opening");
}

/// In the rectangle of its item.
void drawCard(const Rect& rect, const StartCard& card, const gpu::Texture& picture, bool opening) {
    const float line = ImGui::GetFontSize();
    const ImVec2 low{rect.x + line / 3, rect.y + line / 3};
    const ImVec2 high{rect.x + rect.width - line / 3, rect.y + kPictureShape * rect.width};
    if (picture.id() != 0) {
        ImGui::GetWindowDrawList()->AddImageRounded(idOf(picture), low, high, {0, 0}, {1, 1},
                                                    IM_COL32_WHITE, line / 3);
    } else {
        drawPlus({(low.x + high.x) / 2, (low.y + high.y) / 2}, 0.28F * (high.y - low.y));
    }
    const float wrap = rect.width - line;
    const float title = high.y + 0.4F * line;
    drawText({rect.x + line / 2, title}, palette().text, card.title, wrap);
    drawText({rect.x + line / 2, title + heightOf(card.title, wrap) + 0.3F * line},
             palette().dimText, card.tip, wrap);
    if (opening) {
        drawOpening(low, high);
    }
}

}  // namespace

/// Where all is, in its box: rows of cards, and recent files at their right.
struct StartPage::Sheet {
    Sheet(const std::vector<StartCard>& cards, bool withRecent) {
        const ImVec2 display = ImGui::GetIO().DisplaySize;
        box.width = std::min(display.x - 2 * line, std::max(72 * line, 0.55F * display.x));
        const float whole = box.width - 2 * padding;
        aside = withRecent && whole > 44 * line ? std::clamp(whole / 5, 10 * line, 15 * line) : 0;
        width = aside > 0 ? whole - aside - 2 * gap : whole;
        columns = std::clamp(static_cast<int>((width + gap) / (kLeastCard * line + gap)), 2,
                             kCardColumns);
        const int rows = (static_cast<int>(cards.size()) + columns - 1) / columns;
        card.width = std::floor((width - static_cast<float>(columns - 1) * gap) /
                                static_cast<float>(columns));
        float texts = 0;
        for (const StartCard& each : cards) {
            const float wrap = card.width - line;
            texts = std::max(texts, heightOf(each.title, wrap) + heightOf(each.tip, wrap));
        }
        card.height = kPictureShape * card.width + texts + 1.3F * line;
        all = static_cast<float>(rows) * (card.height + gap) - gap;
        box.height = std::min(display.y - 2 * line, heading + all + 2 * padding);
        box.x = std::floor((display.x - box.width) / 2);
        box.y = std::floor((display.y - box.height) / 2);
    }

    float line = ImGui::GetFontSize();
    float gap = std::floor(0.7F * line);
    float padding = std::floor(1.2F * line);
    float heading = std::floor(3.2F * line);
    float width = 0;  ///< of all cards
    float aside = 0;  ///< of the recent files; 0: there is no room
    int columns = kCardColumns;
    float all = 0;  ///< height of the cards
    Rect card;      ///< its size
    Rect box;
};

void StartPage::draw(const StartState& state, std::span<const std::filesystem::path> recent,
                     std::vector<Action>& actions) {
    load(state);
    takeKeys();
    opened_ = state.opening ? opened_ : "";
    const Sheet sheet(cards_, !recent.empty());
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImVec4 dim = ImGui::GetStyleColorVec4(ImGuiCol_ModalWindowDimBg);
    dim.w *= state.overScene ? 2 : 0;
    ImGui::PushStyleColor(ImGuiCol_WindowBg, dim);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    beginPanel("start", {0, 0, display.x, display.y});
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    if (state.overScene && ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) {
        actions.emplace_back(ActionId::cancel);
    }
    ImGui::SetCursorPos({sheet.box.x, sheet.box.y});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, 0.7F * sheet.line);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {sheet.padding, sheet.padding});
    ImGui::BeginChild("sheet", {sheet.box.width, sheet.box.height}, true);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    drawCards(sheet, actions);
    drawRecent(sheet, recent, actions);
    ImGui::EndChild();
    noteItem("start");
    ImGui::End();
}

void StartPage::load(const StartState& state) {
    if (shown_ == state.cards) {
        return;
    }
    shown_ = state.cards;
    cards_ = *shown_;
    cards_.push_back({"file", "Your file...", "Open a model or a session, or drop it here."});
    pictures_.clear();
    for (const StartCard& card : cards_) {
        pictures_.push_back(card.picture ? textureOf(*card.picture) : gpu::Texture());
    }
}

/// The arrows move to the next item, Enter opens it.
void StartPage::takeKeys() {
    moved_ = enters_ = false;
    if (!items_.empty() && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) {
        const std::size_t before = chosen_ = std::min(chosen_, items_.size() - 1);
        const auto step = [this](int key, float right, float down) {
            chosen_ = keyPressed(key, true) ? nextItem(items_, chosen_, right, down) : chosen_;
        };
        step(ImGuiKey_LeftArrow, -1, 0);
        step(ImGuiKey_RightArrow, 1, 0);
        step(ImGuiKey_UpArrow, 0, -1);
        step(ImGuiKey_DownArrow, 0, 1);
        moved_ = chosen_ != before;
        enters_ = keyPressed(ImGuiKey_Enter);
    }
    items_.clear();
}

/// Draws the ground of an item. Returns whether it was clicked, or is entered.
bool StartPage::chooses(const Rect& rect, const std::string& name) {
    const bool chosen = chosen_ == items_.size();
    ImGui::SetCursorScreenPos({rect.x, rect.y});
    const bool clicked = ImGui::InvisibleButton(name.c_str(), {rect.width, rect.height});
    noteItem("start." + name);
    const ImVec2 motion = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemHovered() && (motion.x != 0 || motion.y != 0)) {
        chosen_ = items_.size();
    }
    if (moved_ && chosen) {
        ImGui::SetScrollHereY();
    }
    items_.push_back(rect);
    const ImVec2 end{rect.x + rect.width, rect.y + rect.height};
    const float line = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({rect.x, rect.y}, end,
                       ImGui::GetColorU32(chosen ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                       line / 2);
    if (chosen) {
        draw.AddRect({rect.x, rect.y}, end, palette().of(Hue::blue), line / 2, 0, line / 10);
    }
    return clicked || (chosen && enters_);
}

void StartPage::drawCards(const Sheet& sheet, std::vector<Action>& actions) {
    const ImVec2 top = ImGui::GetCursorScreenPos();
    ImFont* const font = headingFont();
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, top, palette().text,
                                        "What do you want to cut?");
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        const auto column = static_cast<float>(i % sheet.columns);
        const std::size_t line = i / sheet.columns;
        const auto row = static_cast<float>(line);
        const Rect rect{top.x + column * (sheet.card.width + sheet.gap),
                        top.y + sheet.heading + row * (sheet.card.height + sheet.gap),
                        sheet.card.width, sheet.card.height};
        if (chooses(rect, cards_[i].name)) {
            const bool own = i + 1 == cards_.size();
            actions.push_back(own ? Action(ActionId::openFile) : Action(OpenStartScene{i}));
            opened_ = own ? "" : cards_[i].name;
        }
        drawCard(rect, cards_[i], pictures_[i], opened_ == cards_[i].name);
    }
}

void StartPage::drawRecent(const Sheet& sheet, std::span<const std::filesystem::path> recent,
                           std::vector<Action>& actions) {
    if (sheet.aside == 0) {
        return;
    }
    const float line = sheet.line;
    Rect rect{items_[sheet.columns - 1].x + sheet.card.width + 2 * sheet.gap, items_[0].y,
              sheet.aside, 2.9F * line};
    drawText({rect.x, rect.y - 1.6F * line}, palette().dimText, "Recent files");
    const float bottom = rect.y + sheet.all;
    for (const std::filesystem::path& file : recent) {
        if (rect.y + rect.height > bottom) {
            break;
        }
        const std::string name = "recent." + file.filename().string();
        if (chooses(rect, name)) {
            actions.emplace_back(FileAction(OpenFile{file}));
            opened_ = name;
        }
        itemTooltip(file.string());
        drawText({rect.x + line / 2, rect.y + 0.3F * line}, palette().text,
                 shortenedTo(rect.width - line, file.filename().string()));
        drawText({rect.x + line / 2, rect.y + 1.5F * line}, palette().dimText,
                 opened_ == name ? "Opening..." : shortenedTo(rect.width - line, folderText(file)));
        rect.y += rect.height + sheet.gap / 2;
    }
}

}  // namespace kerf::ui
