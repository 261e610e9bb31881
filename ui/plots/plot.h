#pragma once

#include "ui/base/theme.h"
#include "ui/plots/plot_math.h"

namespace kerf::ui {

/// The style of a curve's line, so that curves do not differ only in hue.
enum class CurveStyle { solid, dashed, dotted };

/// One curve of a plot.
struct PlotCurve {
    std::string label;   ///< in the legend, the tooltip and exported files
    unsigned color = 0;  ///< IM_COL32; 0: the palette's `hue`
    Hue hue = Hue::blue;
    CurveStyle style = CurveStyle::solid;
    const Series* series = nullptr;
};

/// A reference value of the curve: a dashed line, or an arrow if out of range.
struct PlotReference {
    double value = 0;
    std::string label;  ///< "paper 98.0"
};

/// Curves over time with their title, legend and marks.
struct PlotSpec {
    const char* id = "";     ///< unique among the plots of a frame; its name in settings and files
    std::string_view title;  ///< "Volume, % of rest"
    std::vector<std::string> notes{};  ///< dim lines below the title
    std::string_view xUnit = "s";
    std::vector<PlotCurve> curves;
    std::span<const PlotMark> marks;  ///< by rising x
    std::optional<PlotReference> reference;
    double minSpan = 1;                 ///< the y axis never shows less than this
    std::optional<PlotRange> yRange{};  ///< what the y axis shows, whatever the values
    int readoutDecimals = 1;            ///< of the last value, and of the one under the pointer
};

/// The time axis that all plots share.
struct PlotTimeline {
    PlotView view;
    double newest = 0;     ///< [s]
    bool running = false;  ///< the newest value moves
    /// The pointer is over one of the plots: all of them show their values at its time.
    bool hovered = false;
    float labels = 0;  ///< least room left of the frames: see labelsWidth() [px]
};
/// The width of the numbers left of a plot of this height [px], for all plots to begin at one x.
float labelsWidth(const PlotSpec& spec, const PlotTimeline& timeline, float height);
/// The time of the newest value of all curves of the plots [s].
double newestOf(std::span<const PlotSpec> plots);

/// Draws the plot as the next item, `height` pixels high over the whole width: title, last value or
/// legend, notes, axes with round ticks, for each curve the band from lowest to highest and the
/// mean, marks, and a crosshair under the pointer. Wheel, drag and double click return another
/// view.
std::optional<PlotView> drawPlot(const PlotSpec& spec, const PlotTimeline& timeline, float height);

}  // namespace kerf::ui
