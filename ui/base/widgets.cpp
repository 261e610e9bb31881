#include "ui/base/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "ui/base/item_rects.h"
#include "ui/base/theme.h"

namespace kerf::ui {
namespace {

float widthOf(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

/// Without its last character, of UTF-8.
std::string_view withoutLast(std::string_view text) {
    const auto continues = [](char byte) { return (static_cast<unsigned char>(byte) >> 6) == 2; };
    while (text.size() > 1 && continues(text.back())) {
        text.remove_suffix(1);
    }
    text.remove_suffix(1);
    return text;
}

}  // namespace

std::string shortenedTo(float width, std::string_view text) {
    std::string shown(text);
    while (!text.empty() && widthOf(shown) > width) {
        text = withoutLast(text);
        shown = text.empty() ? "" : std::string(text) + "\u2026";
    }
    return shown;
}

float topBoxesHeight() {
    return 11 * ImGui::GetFontSize();
}

void beginPanel(const char* name, const Rect& rect, bool withMenu) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse |
                     (withMenu ? ImGuiWindowFlags_MenuBar : ImGuiWindowFlags_None));
}

namespace {

bool beginPopupModal(const std::string& title, bool wanted) {
    if (!ImGui::BeginPopupModal(title.c_str(), nullptr,
                                ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings)) {
        return false;
    }
    if (!wanted) {
        ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    return wanted;
}

}  // namespace

bool beginModal(const std::string& title, float width, float height, bool wanted) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({width, height});
    return beginPopupModal(title, wanted);
}

bool beginModalAside(const std::string& title, const Rect& view, bool wanted) {
    const float margin = ImGui::GetFontSize();
    const float width = std::min(44 * ImGui::GetFontSize(), view.width - 2 * margin);
    ImGui::SetNextWindowPos({view.x + view.width / 2, view.y + view.height - margin},
                            ImGuiCond_Always, {0.5F, 1});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::GetCurrentContext()->DimBgRatio = 0;
    return beginPopupModal(title, wanted);
}

void beginBanner(const char* name, const Rect& content, const BannerStyle& style) {
    const float padding = bannerPadding();
    const ImVec2 box{content.width + 2 * padding, content.height + 1.4F * padding};
    ImGui::SetNextWindowPos(
        {std::floor(content.x - padding), std::max(0.0F, std::floor(content.y - 0.7F * padding))});
    ImGui::SetNextWindowSize(box);
    ImGui::SetNextWindowBgAlpha(0.9F * style.opacity);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, style.opacity);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, 0.7F * padding});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     (style.takesInput ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoInputs) |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    if (style.accent != 0) {
        const ImVec2 low = ImGui::GetWindowPos();
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.PushClipRect(low, {low.x + box.x, low.y + box.y});
        draw.AddRectFilled(low, {low.x + padding * 0.3F, low.y + box.y}, style.accent,
                           ImGui::GetStyle().WindowRounding, ImDrawFlags_RoundCornersLeft);
        draw.PopClipRect();
    }
}

void endBanner() {
    ImGui::End();
    ImGui::PopStyleVar(2);
}

float bannerPadding() {
    return 0.8F * ImGui::GetFontSize();
}

void drawBanner(const char* name, std::string_view text, float x, float y, float maxWidth,
                const BannerStyle& style) {
    const std::string lines = wrapped(text, maxWidth - 2 * bannerPadding());
    const ImVec2 size = ImGui::CalcTextSize(lines.c_str());
    beginBanner(name, {x - size.x / 2, y - size.y / 2, size.x, size.y}, style);
    ImGui::TextUnformatted(lines.c_str());
    endBanner();
}

std::string wrapped(std::string_view text, float width) {
    std::string lines;
    std::string line;
    std::size_t mayEnd = 0;  // behind so many bytes of the line; 0 for nowhere
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool blank = text[i] == ' ' || text[i] == '\n';
        const bool continues = (static_cast<unsigned char>(text[i]) >> 6) == 2;  // of UTF-8
        if (!blank && !continues && !line.empty() && widthOf(line + text[i]) > width) {
            const std::size_t end = mayEnd > 0 ? std::exchange(mayEnd, 0) : line.size();
            lines += line.substr(0, end) + '\n';
            line.erase(0, end);
        }
        line += text[i];
        if (text[i] == '\n') {
            lines += std::exchange(line, {});
            mayEnd = 0;
        } else if (blank &&
                   std::isdigit(static_cast<unsigned char>(text[i > 0 ? i - 1 : 0])) == 0) {
            mayEnd = line.size();
        }
    }
    return lines + line;
}

void textWrapped(std::string_view text, bool dim) {
    const std::string lines = wrapped(text, ImGui::GetContentRegionAvail().x);
    if (dim) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    }
    ImGui::TextUnformatted(lines.c_str());
    if (dim) {
        ImGui::PopStyleColor();
    }
}

void itemTooltip(std::string_view text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        return;
    }
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(wrapped(text, ImGui::GetFontSize() * 22).c_str());
    ImGui::EndTooltip();
}

void placePopupBelowItem() {
    const float gap = ImGui::GetStyle().ItemSpacing.y / 2;
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + gap},
                            ImGuiCond_Appearing);
}

float buttonWidth(std::string_view label) {
    const float text = ImGui::CalcTextSize(label.data(), label.data() + label.size()).x;
    return text + 2 * ImGui::GetStyle().FramePadding.x;
}

void textRight(std::string_view text) {
    const char* end = text.data() + text.size();
    const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.data(), end).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, free));
    ImGui::TextUnformatted(text.data(), end);
}

void textShortened(std::string_view text, float width) {
    ImGui::TextUnformatted(shortenedTo(width, text).c_str());
}

void rowLabel(std::string_view text) {
    constexpr float kShare = 0.43F;  // of the row
    const float width = kShare * ImGui::GetContentRegionAvail().x;
    const float start = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    textShortened(text, width);
    ImGui::SameLine(start + width + ImGui::GetStyle().ItemInnerSpacing.x);
}

void colorRow(std::string_view label, const render::DisplayColor& color) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 0.2F * line},
                                              {at.x + line, at.y + 0.8F * line},
                                              IM_COL32(color[0], color[1], color[2], 255));
    ImGui::Dummy({line, line});
    ImGui::SameLine();
    ImGui::TextUnformatted(label.data(), label.data() + label.size());
}

bool continuesGesture(bool changed) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("gesture");
    const bool active = ImGui::IsItemActive();
    const bool changedBefore = active && storage.GetBool(id);
    storage.SetBool(id, active && (changed || changedBefore));
    return changed && changedBefore;
}

const char* lengthFormat(double size) {
    return size >= 0.2 && size < 200 ? "%.3f" : "%.3g";
}

namespace {

ImGuiSliderFlags flagsOf(const Slide& slide) {
    return ImGuiSliderFlags_AlwaysClamp |
           (slide.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
}

std::string numberOf(const Slide& slide) {
    char text[64];
    if (slide.type == ImGuiDataType_Double) {
        std::snprintf(text, sizeof text, slide.format.c_str(),
                      *static_cast<const double*>(slide.value));
    } else {
        std::snprintf(text, sizeof text, slide.format.c_str(),
                      *static_cast<const int*>(slide.value));
    }
    return text;
}

/// Of the last item; `id` tells it from others of its row.
SlideEdit editOf(const char* id, bool changed) {
    ImGui::PushID(id);
    const SlideEdit edit{changed, continuesGesture(changed)};
    ImGui::PopID();
    return edit;
}

/// The number ends at `right`, on the line.
SlideEdit dragNumber(const Slide& slide, float right) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float pad = 0.3F * ImGui::GetFontSize();
    const float width = widthOf(numberOf(slide)) + 2 * pad;
    ImGui::SameLine();
    ImGui::SetCursorPosX(right - width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {pad, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4{0, 0, 0, 0});
    ImGui::SetNextItemWidth(width);
    const bool changed = ImGui::DragScalar("##number", slide.type, slide.value, 0, slide.low,
                                           slide.high, slide.format.c_str(), flagsOf(slide));
    const SlideEdit made = editOf("number", changed);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - style.ItemSpacing.y + 0.1F * pad);
    return made;
}

/// The knob in a groove that is lower than a line; the number stands elsewhere.
SlideEdit slideKnob(const Slide& slide, float width) {
    constexpr float kHeight = 0.7F;  // of a line
    const float over = (1 - kHeight) / 2 * ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, -over});
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{0, 0, 0, 0});
    ImGui::SetNextItemWidth(width);
    const bool changed =
        ImGui::SliderScalar("##knob", slide.type, slide.value, slide.low, slide.high,
                            slide.format.c_str(), flagsOf(slide) | ImGuiSliderFlags_NoInput);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return editOf("knob", changed);
}

void tellUnlessHeld(const std::string& tooltip) {
    if (!ImGui::IsItemActive() && !tooltip.empty()) {
        itemTooltip(tooltip);
    }
}

}  // namespace

SlideEdit slideRow(const SlideText& text, const Slide& slide, float width, float room) {
    ImGui::PushID(text.item.c_str());
    ImGui::BeginGroup();
    const float left = ImGui::GetCursorPosX();
    const float number = widthOf(numberOf(slide)) + ImGui::GetFontSize() + room;
    ImGui::TextUnformatted(shortenedTo(width - number, text.label).c_str());
    tellUnlessHeld(text.tooltip);
    const SlideEdit dragged = dragNumber(slide, left + width - room);
    noteItem(text.item + ".number");
    tellUnlessHeld(text.tooltip);
    const SlideEdit slid = slideKnob(slide, width);
    noteItem(text.item);
    tellUnlessHeld(text.tooltip);
    ImGui::EndGroup();
    ImGui::PopID();
    return {dragged.changed || slid.changed, dragged.continues || slid.continues};
}

bool keyPressed(int key, bool repeats) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeats);
}

bool resetButton(const char* id) {
    const float side = ImGui::GetFrameHeight();
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4{0, 0, 0, 0});
    const bool pressed = ImGui::Button(id, {side, side});
    ImGui::PopStyleColor();
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 center{low.x + side / 2, low.y + side / 2};
    const float radius = side * 0.22F;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PathArcTo(center, radius, -2.4F, 2.6F, 16);
    draw.PathStroke(palette().of(Hue::orange), 0, side * 0.06F);
    const ImVec2 tip{center.x + radius * std::cos(-2.4F), center.y + radius * std::sin(-2.4F)};
    const float wing = radius * 0.8F;
    draw.AddTriangleFilled({tip.x - wing * 0.35F, tip.y + wing * 0.75F},
                           {tip.x + wing * 0.9F, tip.y + wing * 0.55F},
                           {tip.x - wing * 0.1F, tip.y - wing * 0.7F}, palette().of(Hue::orange));
    return pressed;
}

}  // namespace kerf::ui
