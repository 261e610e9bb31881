#pragma once

#include <algorithm>
#include <optional>

namespace kerf::app {

/// The weighted mean of figures.
struct Mean {
    double sum = 0;
    double weight = 0;

    void add(double value, double by) {
        sum += by * value;
        weight += by;
    }
    std::optional<double> value() const {
        return weight > 0 ? std::optional(sum / weight) : std::nullopt;
    }
};

/// Keeps the larger figure, or the smaller one; none is neither.
inline void raise(std::optional<double>& most, std::optional<double> value) {
    most = value ? std::max(most.value_or(*value), *value) : most;
}
inline void lower(std::optional<double>& least, std::optional<double> value) {
    least = value ? std::min(least.value_or(*value), *value) : least;
}

}  // namespace kerf::app
