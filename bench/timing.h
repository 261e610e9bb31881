#pragma once

#include <chrono>

namespace kerf {

/// The upper of the middle two where their number is even; NaN of none.
inline double median(std::vector<double> values) {
    if (values.empty()) {
        return std::nan("");
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Median wall-clock time of `repeats` calls, after one to warm up [ms].
template <class Call>
double medianMilliseconds(int repeats, Call&& call) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    call();
    for (int i = 0; i < repeats; ++i) {
        const Clock::time_point start = Clock::now();
        call();
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    return median(times);
}

}  // namespace kerf
