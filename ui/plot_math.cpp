#include "ui/plot_math.h"

#include <algorithm>
#include <cmath>

namespace kerf::ui {
namespace {

/// The smallest of 1, 2, 5 times a power of ten that is not below `raw`.
double roundStepUp(double raw) {
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        // A relative slack, so that a raw step of 0.2 stays 0.2.
        if (factor * power >= raw * (1 - 1e-9)) {
            return factor * power;
        }
    }
    return 10 * power;
}

}  // namespace

PlotTicks niceTicks(const PlotRange& range, int maxCount) {
    PlotTicks ticks;
    if (!(range.span() > 0) || !std::isfinite(range.span())) {
        return ticks;
    }
    const double step = roundStepUp(range.span() / std::max(1, maxCount - 1));
    const double slack = 1e-9 * step;
    const double first = std::ceil((range.low - slack) / step);
    const double last = std::floor((range.high + slack) / step);
    for (double k = first; k <= last; ++k) {
        ticks.values.push_back(k * step + 0.0);  // never "-0"
    }
    ticks.decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return ticks;
}

PlotRange paddedRange(std::span<const PlotPoint> points, double minSpan) {
    PlotRange range{1e300, -1e300};
    for (const PlotPoint& p : points) {
        if (std::isfinite(p.y)) {
            range.low = std::min(range.low, p.y);
            range.high = std::max(range.high, p.y);
        }
    }
    if (range.low > range.high) {
        return {0, minSpan};
    }
    const double middle = 0.5 * (range.low + range.high);
    const double half = 0.5 * std::max(1.1 * range.span(), minSpan);
    return {middle - half, middle + half};
}

std::vector<PlotColumn> gatherColumns(std::span<const PlotPoint> points, const PlotRange& x,
                                      int columns) {
    std::vector<PlotColumn> out;
    int count = 0;
    for (const PlotPoint& p : points) {
        if (!std::isfinite(p.y) || p.x < x.low || p.x > x.high) {
            continue;
        }
        const double share = x.span() > 0 ? (p.x - x.low) / x.span() : 0;
        const int column = std::min(columns - 1, static_cast<int>(share * columns));
        if (out.empty() || out.back().column != column) {
            out.push_back({column, p.y, p.y, p.y});
            count = 1;
            continue;
        }
        PlotColumn& last = out.back();
        last.low = std::min(last.low, p.y);
        last.high = std::max(last.high, p.y);
        last.mean += (p.y - last.mean) / ++count;
    }
    return out;
}

}  // namespace kerf::ui
