#include "app/window/monitor.h"

namespace kerf::app {

float scaleOf(int width, int height, int wide, int high) {
    constexpr double kMillimetres = 25.4;  // in an inch
    constexpr double kTolerance = 0.03;    // so that 190 dpi are twice 96
    // Monitors that know only the ratio of their sides report 16 x 9, 160 x 90 or 1600 x 900.
    const bool ratio = wide % 16 == 0 && (wide / 16 == 1 || wide / 16 == 10 || wide / 16 == 100) &&
                       (9 * wide == 16 * high || 10 * wide == 16 * high);
    if (wide <= 0 || high <= 0 || ratio) {
        return 1;
    }
    const double across = width * kMillimetres / wide;
    const double down = height * kMillimetres / high;
    if (std::min(across, down) < 50 || std::max(across, down) > 500) {
        return 1;
    }
    const double scale = std::floor(4 * (std::min(across, down) / 96 + kTolerance)) / 4;
    return static_cast<float>(std::clamp(scale, 1.0, 4.0));
}

const Monitor* monitorOf(const ui::WindowPlace& place, std::span<const Monitor> monitors) {
    const int middle = place.x + place.width / 2;
    const auto found = std::ranges::find_if(monitors, [&](const Monitor& m) {
        return middle >= m.x && middle < m.x + m.width && place.y >= m.y &&
               place.y < m.y + m.height;
    });
    const bool isEmpty = place.width <= 0 || place.height <= 0;
    return found == monitors.end() || isEmpty ? nullptr : &*found;
}

ui::WindowPlace fitted(ui::WindowPlace place, const Monitor& monitor) {
    place.width = std::min(place.width, monitor.width);
    place.height = std::min(place.height, monitor.height);
    place.x = std::clamp(place.x, monitor.x, monitor.x + monitor.width - place.width);
    place.y = std::clamp(place.y, monitor.y, monitor.y + monitor.height - place.height);
    return place;
}

}  // namespace kerf::app
