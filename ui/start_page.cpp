#include "ui/start_page.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "ui/base/item_rects.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

constexpr int kColumns = 4;
constexpr float kPictureShape = 0.625F;  // height over width
const StartCard kOwnFile{"file", "Your own file...", "Open a model or a session, or drop it here.",
                         nullptr};

float wrappedHeight(const std::string& text, float width) {
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
}

void drawText(const ImVec2& at, ImU32 color, const std::string& text, float wrap = 0) {
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, color,
                                        text.c_str(), nullptr, wrap);
}

/// The folder of a file, from the home on where it is there.
std::string folderText(const std::filesystem::path& file) {
    const std::string folder = file.parent_path().string();
    const char* const home = std::getenv("HOME");
    const std::string start = home == nullptr ? "" : home;
    const bool within = start.size() > 1 && folder.starts_with(start) &&
                        (folder.size() == start.size() || folder[start.size()] == '/');
    return within ? "~" + folder.substr(start.size()) : folder;
}

/// The nearest item in a direction, or the same where there is none.
std::size_t nextItem(const std::vector<Rect>& items, std::size_t from, float right, float down) {
    float least = std::numeric_limits<float>::max();
    std::size_t found = from;
    const auto middle = [](const Rect& r) { return ImVec2{r.x + r.width / 2, r.y + r.height / 2}; };
    for (std::size_t i = 0; i < items.size(); ++i) {
        const float x = middle(items[i]).x - middle(items[from]).x;
        const float y = middle(items[i]).y - middle(items[from]).y;
        const float along = right * x + down * y;
        const float far = along + 2 * (std::abs(right * y) + std::abs(down * x));
        if (along > 1 && far < least) {
            least = far;
            found = i;
        }
    }
    return found;
}

/// A plus in a circle.
void drawPlus(const ImVec2& middle, float radius) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = palette().of(Hue::blue);
    const float line = std::max(1.5F, radius / 9);
    const float arm = 0.45F * radius;
    draw.AddCircle(middle, radius, color, 0, line);
    draw.AddLine({middle.x - arm, middle.y}, {middle.x + arm, middle.y}, color, line);
    draw.AddLine({middle.x, middle.y - arm}, {middle.x, middle.y + arm}, color, line);
}

}  // namespace

/// Where all is: cards in two rows, and the recent files at their right, or below where that is too
/// narrow.
struct StartPage::Sheet {
    Sheet(const std::vector<StartCard>& cards, bool withRecent) {
        const ImVec2 display = ImGui::GetIO().DisplaySize;
        const float most = display.x - 2 * line;
        const float whole = std::min(most, std::max(70 * line, 0.5F * display.x)) - 2 * padding;
        const bool hasRoom = whole > 58 * line;
        aside = withRecent && hasRoom ? 15 * line : 0;
        width = aside > 0 ? whole - aside - 2 * gap : whole;
        card = std::floor((width - (kColumns - 1) * gap) / kColumns);
        float tips = wrappedHeight(kOwnFile.tip, card - line);
        for (const StartCard& each : cards) {
            tips = std::max(tips, wrappedHeight(each.tip, card - line));
        }
        cardHeight = kPictureShape * card + tips + 2.3F * line;
        below = withRecent && aside == 0 ? 1.8F * line + 2 * (row + gap / 2) : 0;
        const float content = heading + 2 * cardHeight + gap + (below > 0 ? gap + below : 0);
        const float height = std::min(display.y - 2 * line, content + 2 * padding);
        box = {std::floor((display.x - whole) / 2 - padding), std::floor((display.y - height) / 2),
               whole + 2 * padding, height};
    }

    float line = ImGui::GetFontSize();
    float gap = std::floor(0.7F * line);
    float padding = std::floor(1.2F * line);
    float heading = std::floor(3.2F * line);
    float row = std::floor(2.9F * line);  ///< of a recent file
    float width = 0;                      ///< of all cards
    float card = 0;                       ///< width of one
    float cardHeight = 0;
    float aside = 0;  ///< width of the recent files at the right
    float below = 0;  ///< their height below
    Rect box;         ///< in the window
};

void StartPage::draw(const StartState& state, std::span<const std::filesystem::path> recent,
                     std::vector<Action>& actions) {
    load(state);
    takeKeys();
    const Sheet sheet(*state.cards, !recent.empty());
    const ImVec4 dim = ImGui::GetStyleColorVec4(ImGuiCol_ModalWindowDimBg);
    ImGui::PushStyleColor(ImGuiCol_WindowBg,
                          {dim.x, dim.y, dim.z, state.overScene ? 2 * dim.w : 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    beginPanel("start", {0, 0, display.x, display.y});
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    const bool beside =
        state.overScene && ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    ImGui::SetCursorPos({sheet.box.x, sheet.box.y});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, 0.7F * sheet.line);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {sheet.padding, sheet.padding});
    ImGui::BeginChild("sheet", {sheet.box.width, sheet.box.height}, true, ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    const bool within = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    drawCards(state, sheet, actions);
    drawRecent(sheet, recent, actions);
    ImGui::EndChild();
    noteItem("start");
    ImGui::End();
    if (beside && !within) {
        actions.emplace_back(ActionId::cancel);
    }
}

void StartPage::load(const StartState& state) {
    if (cards_ == state.cards) {
        return;
    }
    cards_ = state.cards;
    pictures_.clear();
    for (const StartCard& card : *cards_) {
        pictures_.push_back(card.picture ? Picture(*card.picture) : Picture());
    }
    pictures_.emplace_back();  // of a file of one's own
}

/// The arrows move to the next item, Enter opens it. The answer is that of the last update.
void StartPage::takeKeys() {
    moved_ = enters_ = false;
    chosen_ = std::min(chosen_, items_.empty() ? 0 : items_.size() - 1);
    if (!items_.empty() && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) {
        const std::size_t before = chosen_;
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

/// Draws the ground of an item. Returns whether it was clicked, or chosen by a key.
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
    const float rounding = 0.5F * ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({rect.x, rect.y}, end,
                       ImGui::GetColorU32(chosen ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                       rounding);
    if (chosen) {
        draw.AddRect({rect.x, rect.y}, end, palette().of(Hue::blue), rounding, 0,
                     std::max(1.5F, 0.1F * ImGui::GetFontSize()));
    }
    return clicked || (chosen && enters_);
}

void StartPage::drawCard(const Sheet& sheet, const Rect& rect, const StartCard& card,
                         const Picture& picture) {
    const float inset = std::floor(0.35F * sheet.line);
    const ImVec2 low{rect.x + inset, rect.y + inset};
    const ImVec2 high{rect.x + rect.width - inset, rect.y + kPictureShape * rect.width};
    if (picture) {
        ImGui::GetWindowDrawList()->AddImageRounded(picture.id(), low, high, {0, 0}, {1, 1},
                                                    IM_COL32_WHITE, 0.35F * sheet.line);
    } else {
        drawPlus({(low.x + high.x) / 2, (low.y + high.y) / 2}, 0.28F * (high.y - low.y));
    }
    const ImVec2 text{rect.x + sheet.line / 2, high.y + 0.4F * sheet.line};
    drawText(text, palette().text, card.title);
    drawText({text.x, text.y + 1.3F * sheet.line}, palette().dimText, card.tip,
             rect.width - sheet.line);
}

void StartPage::drawCards(const StartState& state, const Sheet& sheet,
                          std::vector<Action>& actions) {
    const ImVec2 top = ImGui::GetCursorScreenPos();
    ImFont* const font = headingFont();
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, top, palette().text,
                                        "What do you want to cut?");
    for (std::size_t i = 0; i <= state.cards->size(); ++i) {
        const auto column = static_cast<float>(i % kColumns);
        const auto row = static_cast<float>(i / kColumns);
        const Rect rect{top.x + column * (sheet.card + sheet.gap),
                        top.y + sheet.heading + row * (sheet.cardHeight + sheet.gap), sheet.card,
                        sheet.cardHeight};
        const bool own = i == state.cards->size();
        const StartCard& card = own ? kOwnFile : (*state.cards)[i];
        if (chooses(rect, card.name)) {
            actions.emplace_back(own ? Action(ActionId::openFile)
                                     : Action(OpenStartScene{card.name}));
        }
        drawCard(sheet, rect, card, pictures_[i]);
    }
}

void StartPage::drawRecent(const Sheet& sheet, std::span<const std::filesystem::path> recent,
                           std::vector<Action>& actions) {
    if (recent.empty()) {
        return;
    }
    const bool below = sheet.aside == 0;
    const ImVec2 start = ImGui::GetWindowPos();
    const float scroll = ImGui::GetScrollY();
    const float left = start.x + sheet.padding + (below ? 0 : sheet.width + 2 * sheet.gap);
    const float grid = 2 * sheet.cardHeight + sheet.gap;
    const float top =
        start.y + sheet.padding - scroll +
        (below ? sheet.heading + grid + sheet.gap : sheet.heading - 1.8F * sheet.line);
    drawText({left, top}, palette().dimText, "Recent files");
    const int columns = below ? std::max(1, static_cast<int>(sheet.width / (16 * sheet.line))) : 1;
    const float pitch = sheet.row + sheet.gap / 2;
    const int rows = below ? 2 : static_cast<int>((grid + sheet.gap / 2) / pitch);
    const float width = below ? (sheet.width - static_cast<float>(columns - 1) * sheet.gap) /
                                    static_cast<float>(columns)
                              : sheet.aside;
    const auto count = std::min(recent.size(), static_cast<std::size_t>(columns * rows));
    for (std::size_t i = 0; i < count; ++i) {
        const std::filesystem::path& file = recent[i];
        const int row = static_cast<int>(i) / columns;
        const int column = static_cast<int>(i) % columns;
        const Rect rect{left + static_cast<float>(column) * (width + sheet.gap),
                        top + 1.8F * sheet.line + static_cast<float>(row) * pitch, width,
                        sheet.row};
        if (chooses(rect, "recent." + file.filename().string())) {
            actions.emplace_back(FileAction(OpenFile{file}));
        }
        itemTooltip(file.string());
        const float room = rect.width - sheet.line;
        const ImVec2 text{rect.x + sheet.line / 2, rect.y + 0.3F * sheet.line};
        drawText(text, palette().text, shortenedTo(room, file.filename().string()));
        drawText({text.x, text.y + 1.2F * sheet.line}, palette().dimText,
                 shortenedTo(room, folderText(file)));
    }
    ImGui::SetCursorScreenPos({left, top + 1.8F * sheet.line});
    ImGui::Dummy({1, static_cast<float>(rows) * pitch - sheet.gap / 2});
}

}  // namespace kerf::ui
