#pragma once

namespace kerf::ui {

/// A rectangle in pixels of the picture, from its top left corner.
struct Rect {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;
};

/// Where the fixed panels stand; the view fills the whole picture behind them.
struct Layout {
    Rect controls;  ///< left
    Rect plots;     ///< right
    Rect status;    ///< bottom, full width
    Rect view;      ///< what the panels leave free, for hints and toasts
};

/// `scale` is the display's (1 = 96 dpi). Both side panels give way in narrow windows, so that at
/// least a third of the width stays free.
Layout layoutPanels(float width, float height, float scale);

}  // namespace kerf::ui
