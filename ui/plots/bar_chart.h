#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/scene/image.h"
#include "ui/base/picture_painter.h"

namespace kerf::ui {

/// A bar from 0 to a value of at least 0.
struct Bar {
    double value = 0;
    /// Smallest and largest value, drawn as an error bar.
    struct Spread {
        double low = 0;
        double high = 0;
    };
    std::optional<Spread> spread;
};

/// Bars that stand side by side, one of each kind.
struct BarGroup {
    std::string label;
    std::vector<std::optional<Bar>> bars;  ///< nothing where a kind has none here
};

/// The kind of the bars that stand at one place of all groups.
struct BarKind {
    std::string label;  ///< in the legend
    Hue hue = Hue::blue;
};

/// Groups of bars over one axis, with their values above them.
struct BarChart {
    std::string title;  ///< "Frames per second"
    std::vector<BarKind> kinds;
    std::vector<BarGroup> groups;
    int decimals = 1;  ///< of the values
};

/// The chart as a picture of so many pixels.
render::Image drawBarChart(PicturePainter& painter, const BarChart& chart, int width, int height);

}  // namespace kerf::ui
