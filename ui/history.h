#pragma once

#include <vector>

#include "ui/plot_math.h"

namespace kerf::ui {

/// What the plots show, against simulated time [s].
struct History {
    std::vector<PlotPoint> framesPerSecond;
    std::vector<PlotPoint> volumePercent;  ///< of the uncut rest shape
    std::vector<PlotMark> marks;           ///< cuts, by time

    void clear() { *this = History{}; }
};

}  // namespace kerf::ui
