#pragma once

#include "ui/base/settings.h"

namespace kerf::ui {

/// A rectangle in pixels of the picture, from its top left corner.
struct Rect {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;

    bool holds(float px, float py) const {
        return px >= x && px < x + width && py >= y && py < y + height;
    }
};

/// The rectangles of the fixed panels; the view fills the whole picture behind them.
struct Layout {
    Rect controls;      ///< left; without width if hidden
    Rect plots;         ///< right; without width if hidden
    Rect timeline;      ///< above it, full width; without height where there is none
    Rect status;        ///< bottom, full width
    Rect view;          ///< area free of panels, for hints and toasts
    Rect controlsEdge;  ///< between the left panel and the view: drags its width
    Rect plotsEdge;     ///< between the view and the right panel
};

/// Lays the fixed panels out. `scale` is that of all lengths (1 = 96 dpi). Both side panels shrink
/// in narrow windows, so that at least a third of the width stays free.
Layout layoutPanels(float width, float height, float scale, const Settings& settings = {},
                    bool withTimeline = false);

/// The smallest layout of the panels, at scale 1 [px]. In a smaller window they are cut off.
inline constexpr float kLeastWidth = 640;
inline constexpr float kLeastHeight = 360;
inline constexpr float kLeastScale = 0.5F;
/// The largest scale, in quarters, at which the panels have that room in a window; kLeastScale at
/// least.
float largestScale(int width, int height);

/// The rectangles in which named items of the panels were drawn in the last update [px]. Tests
/// click on them, so that they do not depend on the layout.
using ItemRects = std::map<std::string, Rect, std::less<>>;

/// Records the last item under a name ("transport.play") in the rectangles of the current update.
void noteItem(const std::string& name);

/// Has a panel scroll to the item of that name in the next updates; a number there is typed.
void seekItem(const std::string& name);
/// Whether it is sought and was not drawn yet.
bool isSought(std::string_view name);

/// A scope in which noteItem() writes into the given rectangles.
class ItemNotes {
  public:
    explicit ItemNotes(ItemRects& rects);
    ~ItemNotes();
    ItemNotes(const ItemNotes&) = delete;
    ItemNotes& operator=(const ItemNotes&) = delete;
};

}  // namespace kerf::ui
