#pragma once

#include "ui/base/settings.h"

namespace kerf::app {

/// The part of the desktop [px] that windows have on a monitor, and its scale where the desktop
/// names none.
struct Monitor {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    float scale = 1;
};

/// The scale at which letters are as large as at 96 dpi on a monitor of `width` x `height` pixels
/// that reports a size in millimetres: in steps of a quarter, rounded down, from 1 to 4. It is 1
/// where that size is nonsense, such as the ratio of the sides.
float scaleOf(int width, int height, int wide, int high);
/// The monitor that has the middle of the window's upper edge, by which it is moved; null for none.
const Monitor* monitorOf(const ui::WindowPlace& place, std::span<const Monitor> monitors);

/// Moved onto the monitor, and shrunk if larger.
ui::WindowPlace fitted(ui::WindowPlace place, const Monitor& monitor);

}  // namespace kerf::app
