#pragma once

#include "render/scene/overlays.h"
#include "ui/base/layout.h"

namespace kerf::ui {

/// Begins a fixed panel that fills `rect`; end with ImGui::End().
void beginPanel(const char* name, const Rect& rect, bool withMenu = false);

/// Begins a modal window of a size [px] (height 0: as its content needs) in the middle of the
/// picture, once it was opened by its title's popup id; end with ImGui::EndPopup(). With `wanted`
/// false it closes. Returns false if nothing is to be drawn.
bool beginModal(const std::string& title, float width, float height, bool wanted);

/// beginModal() at the lower edge of `view` [px], which is not dimmed.
bool beginModalAside(const std::string& title, const Rect& view, bool wanted);

/// The look of a banner.
struct BannerStyle {
    unsigned accent = 0;  ///< colour of the bar at its left, 0 for none
    float opacity = 1;
};
/// Begins a dark rounded background around `content` [px]; end with endBanner(). A press on it is
/// the view's: controls go into beginControl().
void beginBanner(const char* name, const Rect& content, const BannerStyle& style);
/// Ends the banner that beginBanner() began.
void endBanner();
/// Begins a place over the view, of that size [px], for a control, which alone takes presses; end
/// with endControl().
void beginControl(const std::string& name, const Rect& place);
void endControl();
/// The gap between the content of a banner and its sides [px].
float bannerPadding();
/// Draws a text without interaction on a dark rounded background, centred at (x, y) [px], wrapped
/// at `maxWidth`.
void drawBanner(const char* name, std::string_view text, float x, float y, float maxWidth,
                const BannerStyle& style);

/// A text in lines of at most `width` [px]. They break at spaces, but not between a number and its
/// unit, and in words that are longer.
std::string wrapped(std::string_view text, float width);
/// Draws a text wrapped into the rest of the line, dim if it is an aside.
void textWrapped(std::string_view text, bool dim = false);

/// Draws a text in a colour.
void textColored(unsigned color, std::string_view text);

/// Shows `text` beside the last item while the pointer rests on it, unless it is empty.
void itemTooltip(std::string_view text);
/// noteItem() and itemTooltip().
void describeItem(const std::string& name, std::string_view tooltip);

/// Those of Dear ImGui with a name for tests and a tooltip. `width` [px]: 0 as the label needs, -1
/// the rest of the line. They return whether they were clicked.
bool button(const char* label, const std::string& name, std::string_view tooltip = "",
            float width = 0);
bool smallButton(const char* label, const std::string& name, std::string_view tooltip = "");
bool checkbox(const char* label, bool& on, const std::string& name, std::string_view tooltip = "");

/// Makes the next popup open below the last item instead of over it.
void placePopupBelowItem();

/// The width of a button with this text [px].
float buttonWidth(std::string_view label);

/// Below the upper edge of the view, where work, toasts and axes end [px].
float topBoxesHeight();

/// The text with an ellipsis at its end if it is wider than `width` [px]; "" if not even that fits.
std::string shortenedTo(float width, std::string_view text);

/// Draws a text at the right end of the line or the table's cell.
void textRight(std::string_view text);

/// Draws a text, with an ellipsis where it is wider than `width` [px]; then a tooltip has all of
/// it.
void textShortened(std::string_view text, float width);

/// Draws the left part of a row, with an ellipsis if too long. The right part comes next on the
/// line.
void rowLabel(std::string_view text);

/// Draws a row of a legend: a patch of a colour, and its meaning.
void colorRow(std::string_view label, const render::DisplayColor& color);

/// Whether the drag of the last item already changed it in an earlier update, so that one undo
/// reverts the drag. Call it in each update, with whether this one changed the item; one item per
/// id on the stack.
bool continuesGesture(bool changed);

/// The format of numbers in metres about a body of this size [m]: three decimals, or three digits
/// if it is tiny or huge.
const char* lengthFormat(double size);
/// The number of a slider: of ImGui's type `type`, from `low` to `high`.
struct Slide {
    int type = 0;  ///< ImGuiDataType
    void* value = nullptr;
    const void* low = nullptr;
    const void* high = nullptr;
    std::string format;  ///< with the unit: "%.3f m"
    bool logarithmic = false;
    std::string unit = {};  ///< of what is typed, where the format has none
};
/// The label of a slider, and its name for tests.
struct SlideText {
    std::string label;
    std::string tooltip;
    std::string item;
};
/// A change of a value in this update.
struct SlideEdit {
    bool changed = false;
    bool continues = false;  ///< part of the previous gesture
};
/// Draws a label and, at the right end of the line, the number, which is dragged, or typed after a
/// click; below them the slider. A number changes once it is accepted. All in `width` [px], of
/// which the number leaves `room` free.
SlideEdit slideRow(const SlideText& text, const Slide& slide, float width, float room = 0);

/// The speed of numbers that are typed only.
inline constexpr float kTypedOnly = -1;
/// Numbers side by side, each dragged by `speed` per pixel, or typed after a click. Returns whether
/// one changed.
bool dragNumbers(std::span<double> values, Slide slide, float speed);
/// Whether a typed number was refused in this update.
bool refusedNumber();

/// Whether a key of Dear ImGui went down in this picture, or `repeats` as it is held.
bool keyPressed(int key, bool repeats = false);
/// Whether a key went down in this picture.
bool isPressed(Key key);

/// Draws a small square button with a turning arrow, drawn rather than taken from the font.
bool resetButton(const char* id);

}  // namespace kerf::ui
