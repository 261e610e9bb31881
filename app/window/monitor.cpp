#include "app/window/monitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kerf::app {
namespace {

constexpr double kDpi = 96;
constexpr double kMillimetres = 25.4;  // in an inch
constexpr double kLeastDpi = 50;
constexpr double kMostDpi = 500;
constexpr double kStep = 0.25;
constexpr double kTolerance = 0.05;  // so that 191 dpi are twice 96
constexpr double kLargest = 4;

// What monitors report that know only the ratio of their sides.
constexpr std::array<std::pair<int, int>, 6> kRatios{
    {{16, 9}, {16, 10}, {160, 90}, {160, 100}, {1600, 900}, {1600, 1000}}};

}  // namespace

float scaleOf(const Monitor& monitor) {
    if (monitor.wide <= 0 || monitor.high <= 0 ||
        std::ranges::find(kRatios, std::pair(monitor.wide, monitor.high)) != kRatios.end()) {
        return 1;
    }
    const double across = monitor.width * kMillimetres / monitor.wide;
    const double down = monitor.height * kMillimetres / monitor.high;
    const double dpi = std::min(across, down);
    if (!(dpi >= kLeastDpi && std::max(across, down) <= kMostDpi)) {
        return 1;
    }
    const double scale = std::floor((dpi / kDpi + kTolerance) / kStep) * kStep;
    return static_cast<float>(std::clamp(scale, 1.0, kLargest));
}

bool isReachable(const ui::WindowPlace& place, std::span<const Monitor> monitors) {
    const int middle = place.x + place.width / 2;
    return place.width > 0 && place.height > 0 &&
           std::ranges::any_of(monitors, [&](const Monitor& m) {
               return middle >= m.x && middle < m.x + m.width && place.y >= m.y &&
                      place.y < m.y + m.height;
           });
}

}  // namespace kerf::app
