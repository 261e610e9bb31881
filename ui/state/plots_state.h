#pragma once

#include <optional>

#include "ui/plots/history.h"
#include "ui/plots/plot_math.h"

namespace kerf::ui {

/// What the plots show.
struct PlotsState {
    const History* history = nullptr;  ///< never null while panels are drawn
    std::optional<RunFigures> paper;   ///< of the open experiment, if in the paper
    PlotView view;
};

}  // namespace kerf::ui
