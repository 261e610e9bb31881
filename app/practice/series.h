#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "sim/base/math.h"

namespace kerf::app {

/// Running statistics of a figure; each is none as long as nothing was added.
struct Statistics {
    std::optional<double> mean;
    std::optional<double> least;
    std::optional<double> most;
    double weight = 0;

    void add(double value, double by = 1) {
        weight += by;
        mean = mean.value_or(value) + by / weight * (value - mean.value_or(value));
        least = std::min(least.value_or(value), value);
        most = std::max(most.value_or(value), value);
    }
};

/// Points over time or over length: linear in between, constant before and behind.
struct Curve {
    std::vector<double> at;  ///< ascending
    std::vector<Vec3> points;

    void add(double where, const Vec3& point) {
        at.push_back(where);
        points.push_back(point);
    }
    double span() const { return at.back() - at.front(); }
    /// The curve must have a point.
    Vec3 operator()(double where) const {
        const std::size_t next = std::ranges::upper_bound(at, where) - at.begin();
        if (next == 0 || next == at.size()) {
            return next == 0 ? points.front() : points.back();
        }
        const double share = (where - at[next - 1]) / (at[next] - at[next - 1]);
        return points[next - 1] + share * (points[next] - points[next - 1]);
    }
};

}  // namespace kerf::app
