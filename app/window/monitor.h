#pragma once

#include <span>

#include "ui/base/settings.h"

namespace kerf::app {

/// A monitor: its part of the desktop [px], and its size [mm] as it reports it.
struct Monitor {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    int wide = 0;
    int high = 0;
};

/// The scale at which letters are as large as at 96 dpi, in steps of a quarter, rounded down, from
/// 1 to 4. It is 1 where the reported size is nonsense, such as the ratio of the sides.
float scaleOf(const Monitor& monitor);
/// Whether a window there could be seen and moved: the middle of its upper edge is on a monitor.
bool isReachable(const ui::WindowPlace& place, std::span<const Monitor> monitors);

}  // namespace kerf::app
