#include "ui/base/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <spdlog/fmt/fmt.h>

#include <cctype>
#include <cstring>

#include "ui/base/theme.h"
#include "ui/base/unit_text.h"

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
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
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

void beginControl(const std::string& name, const Rect& place) {
    ImGui::SetNextWindowPos({place.x, place.y});
    ImGui::SetNextWindowSize({place.width, place.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin(name.c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
}

void endControl() {
    ImGui::End();
    ImGui::PopStyleVar(3);
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
    const ImVec4& color = ImGui::GetStyleColorVec4(dim ? ImGuiCol_TextDisabled : ImGuiCol_Text);
    textColored(ImGui::ColorConvertFloat4ToU32(color), lines);
}

void textColored(unsigned color, std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

void itemTooltip(std::string_view text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        return;
    }
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(wrapped(text, ImGui::GetFontSize() * 22).c_str());
    ImGui::EndTooltip();
}

void describeItem(const std::string& name, std::string_view tooltip) {
    noteItem(name);
    itemTooltip(tooltip);
}

bool button(const char* label, const std::string& name, std::string_view tooltip, float width) {
    const bool clicked = ImGui::Button(label, {width, 0});
    describeItem(name, tooltip);
    return clicked;
}

bool smallButton(const char* label, const std::string& name, std::string_view tooltip) {
    const bool clicked = ImGui::SmallButton(label);
    describeItem(name, tooltip);
    return clicked;
}

bool checkbox(const char* label, bool& on, const std::string& name, std::string_view tooltip) {
    const bool clicked = ImGui::Checkbox(label, &on);
    describeItem(name, tooltip);
    return clicked;
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
    const std::string shown = shortenedTo(width, text);
    ImGui::TextUnformatted(shown.c_str());
    if (shown != text) {
        itemTooltip(text);
    }
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

double numberAt(int type, const void* value) {
    return type == ImGuiDataType_Double ? *static_cast<const double*>(value)
                                        : *static_cast<const int*>(value);
}

std::string numberOf(const Slide& slide) {
    char text[64];
    ImGui::DataTypeFormatString(text, sizeof text, slide.type, slide.value, slide.format.c_str());
    return text;
}

/// A text that is being typed: nothing changes before it is accepted.
struct TypedNumber {
    std::string text;
    bool edited = false;
    int frame = 0;  ///< of the last update in which it was shown
};
std::map<ImGuiID, TypedNumber> typedNumbers;

/// What fits where a typed text did not, shown below its field until the next click or key.
struct Refusal {
    ImGuiID item = 0;
    std::string fits;
    int frame = 0;
};
Refusal refusal;

/// "m" of "%.3f m".
std::string unitOf(const Slide& slide) {
    std::string unit = slide.format.substr(slide.format.find_first_of("dfg") + 1);
    std::erase(unit, ' ');
    return !slide.unit.empty() ? slide.unit : unit == "%%" ? "%" : unit;
}

/// "0.001 to 100 m" and what becomes of a number beyond that, or what fits instead of the text.
std::string adviceOn(const Slide& slide, const std::string& text) {
    const double low = numberAt(slide.type, slide.low);
    const double high = numberAt(slide.type, slide.high);
    const std::string unit = unitOf(slide);
    const std::optional<double> typed = readNumber(text, unit);
    if (!typed && !text.empty()) {
        return whatFits(unit);
    }
    const bool inside = !typed || (*typed >= low && *typed <= high);
    return fmt::format("{:g} to {:g}{}{}", low, high, unit.empty() ? "" : " ", unit) +
           (inside ? "" : fmt::format("; Enter takes {:g}", std::clamp(*typed, low, high)));
}

/// Returns whether that changed it.
bool setNumber(const Slide& slide, double number) {
    const double before = numberAt(slide.type, slide.value);
    const double now =
        std::clamp(number, numberAt(slide.type, slide.low), numberAt(slide.type, slide.high));
    if (slide.type == ImGuiDataType_Double) {
        *static_cast<double*>(slide.value) = now;
    } else {
        *static_cast<int*>(slide.value) = static_cast<int>(std::lround(now));
    }
    return numberAt(slide.type, slide.value) != before;
}

/// Takes what was typed, unless it was left by Escape. Returns whether that changed the number.
bool acceptTyped(const Slide& slide, ImGuiID item, const TypedNumber& typed) {
    if (typed.frame < ImGui::GetFrameCount() - 1 || !typed.edited || typed.text.empty()) {
        return false;
    }
    const std::string unit = unitOf(slide);
    const std::optional<double> number = readNumber(typed.text, unit);
    if (!number) {
        refusal = {item, whatFits(unit), ImGui::GetFrameCount()};
    }
    return number && setNumber(slide, *number);
}

/// The field in which a number is typed. Dear ImGui's own takes no letters, and so no unit.
void typeNumber(const char* id, const Slide& slide, TypedNumber& typed) {
    char buffer[32];
    ImStrncpy(buffer, typed.text.c_str(), sizeof buffer);
    ImGui::InputText(id, buffer, sizeof buffer);
    const ImGuiInputTextState& state = ImGui::GetCurrentContext()->InputTextState;
    typed = {buffer, std::strcmp(buffer, state.InitialTextA.Data) != 0, ImGui::GetFrameCount()};
    ImGui::SetTooltip("%s", adviceOn(slide, typed.text).c_str());
}

void tellRefusal(ImGuiID item) {
    const bool ends =
        ImGui::IsMouseClicked(0) || keyPressed(ImGuiKey_Enter) || keyPressed(ImGuiKey_Escape);
    if (refusal.item != item || (ends && !refusedNumber())) {
        refusal.item = refusal.item == item ? 0 : refusal.item;
        return;
    }
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y});
    ImGui::Begin("##refused", nullptr,
                 ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::TextUnformatted(refusal.fits.c_str());
    noteItem("refused." + refusal.fits);
    ImGui::End();
}

/// A number that is dragged, or typed after a click.
bool dragScalar(const char* id, const Slide& slide, float speed) {
    const ImGuiID item = ImGui::GetID(id);
    double real = numberAt(slide.type, slide.value);
    int whole = static_cast<int>(real);
    void* const shown = slide.type == ImGuiDataType_Double ? static_cast<void*>(&real) : &whole;
    bool dragged = false;
    if (ImGui::TempInputIsActive(item)) {
        typeNumber(id, slide, typedNumbers[item]);
    } else {
        const int only = speed == kTypedOnly ? ImGuiSliderFlags_ReadOnly : 0;
        dragged = ImGui::DragScalar(id, slide.type, shown, std::max(speed, 0.0F), slide.low,
                                    slide.high, slide.format.c_str(), flagsOf(slide) | only);
    }
    if (ImGui::TempInputIsActive(item)) {
        typedNumbers[item].frame = ImGui::GetFrameCount();
        return false;
    }
    const auto typing = typedNumbers.extract(item);
    const bool changed = typing ? acceptTyped(slide, item, typing.mapped())
                                : dragged && setNumber(slide, numberAt(slide.type, shown));
    tellRefusal(item);
    return changed;
}

/// Of the number, with room to type [px].
float numberWidth(const Slide& slide) {
    const bool typed = typedNumbers.contains(ImGui::GetID("##number"));
    return std::max(widthOf(numberOf(slide)), typed ? 6 * ImGui::GetFontSize() : 0);
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
    const float width = numberWidth(slide) + 2 * pad;
    ImGui::SameLine();
    ImGui::SetCursorPosX(right - width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {pad, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4{0, 0, 0, 0});
    ImGui::SetNextItemWidth(width);
    const bool changed = dragScalar("##number", slide, 0);
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
    if (!ImGui::IsItemActive()) {
        itemTooltip(tooltip);
    }
}

}  // namespace

SlideEdit slideRow(const SlideText& text, const Slide& slide, float width, float room) {
    ImGui::PushID(text.item.c_str());
    ImGui::BeginGroup();
    const float left = ImGui::GetCursorPosX();
    const float number = numberWidth(slide) + ImGui::GetFontSize() + room;
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

bool dragNumbers(std::span<double> values, Slide slide, float speed) {
    bool changed = false;
    ImGui::BeginGroup();
    ImGui::PushMultiItemsWidths(static_cast<int>(values.size()), ImGui::CalcItemWidth());
    for (double& value : values) {
        slide.value = &value;
        ImGui::PushID(static_cast<int>(&value - values.data()));
        changed |= dragScalar("##value", slide, speed);
        ImGui::PopID();
        ImGui::PopItemWidth();
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    ImGui::NewLine();
    ImGui::EndGroup();
    return changed;
}

bool refusedNumber() {
    return refusal.item != 0 && refusal.frame == ImGui::GetFrameCount();
}

bool keyPressed(int key, bool repeats) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(static_cast<ImGuiKey>(key)), repeats);
}

bool isPressed(Key key) {
    return ImGui::IsKeyPressed(static_cast<ImGuiKey>(key), false);
}

bool resetButton(const char* id) {
    const float side = ImGui::GetFrameHeight();
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4{0, 0, 0, 0});
    ImGui::PushID(id);
    const bool pressed = ImGui::Button("##reset", {side, side});
    ImGui::PopID();
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
