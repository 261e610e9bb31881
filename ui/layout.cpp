#include "ui/layout.h"

#include <algorithm>

namespace kerf::ui {

Layout layoutPanels(float width, float height, float scale) {
    constexpr float kSideWidth = 300;
    constexpr float kMargin = 8;
    constexpr float kStatusHeight = 28;
    const float margin = kMargin * scale;
    const float status = kStatusHeight * scale;
    const float side = std::min(kSideWidth * scale, width / 3 - margin);
    const float panelHeight = std::max(1.0F, height - status - 2 * margin);

    Layout layout;
    layout.controls = {margin, margin, side, panelHeight};
    layout.plots = {width - margin - side, margin, side, panelHeight};
    layout.status = {0, height - status, width, status};
    layout.view = {2 * margin + side, margin, width - 4 * margin - 2 * side, panelHeight};
    return layout;
}

}  // namespace kerf::ui
