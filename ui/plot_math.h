#pragma once

#include <span>
#include <string>
#include <vector>

namespace kerf::ui {

/// A value y at x.
struct PlotPoint {
    double x = 0;
    double y = 0;
};

/// Something that happened at x.
struct PlotMark {
    double x = 0;
    std::string label;
};

/// What an axis shows.
struct PlotRange {
    double low = 0;
    double high = 1;
    double span() const { return high - low; }
    bool operator==(const PlotRange&) const = default;
};

/// Round numbers (1, 2 or 5 times a power of ten apart) inside the range, at most `maxCount`
/// (at least 2), rising. `decimals` is what a label needs to tell neighbours apart.
struct PlotTicks {
    std::vector<double> values;
    int decimals = 0;
};
PlotTicks niceTicks(const PlotRange& range, int maxCount);

/// The values' range with a margin of a twentieth at both ends, opened about its middle to at
/// least `minSpan`. Values that are not finite are left out; {0, minSpan} where nothing is left.
PlotRange paddedRange(std::span<const PlotPoint> points, double minSpan);

/// Lowest, highest and mean value of the points in one column of pixels.
struct PlotColumn {
    int column = 0;
    double low = 0;
    double high = 0;
    double mean = 0;
};
/// Points (by rising x) gathered into `columns` equal columns of `x`; empty ones are left out, as
/// are points outside and values that are not finite.
std::vector<PlotColumn> gatherColumns(std::span<const PlotPoint> points, const PlotRange& x,
                                      int columns);

}  // namespace kerf::ui
