#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ui/plot_math.h"

namespace kerf::ui {

/// One curve against time with what belongs to it.
struct PlotSpec {
    const char* id = "";     ///< unique among the plots of a frame
    std::string_view title;  ///< "Volume, % of rest"
    std::string_view xUnit = "s";
    unsigned color = 0;                 ///< IM_COL32
    std::span<const PlotPoint> points;  ///< by rising x
    std::span<const PlotMark> marks;    ///< by rising x
    std::optional<double> reference;    ///< dashed line
    double minSpan = 1;                 ///< the y axis never shows less than this
    int readoutDecimals = 1;            ///< of the last value, and of the one under the pointer
};

/// Draws the plot as the next item, `height` pixels high over the whole width: title, last value,
/// axes with round ticks, the min-max band and the mean, marks, and a crosshair under the pointer.
void drawPlot(const PlotSpec& spec, float height);

}  // namespace kerf::ui
