#pragma once

#include <optional>

#include "ui/plots/history.h"
#include "ui/plots/plot_math.h"

namespace kerf::ui {

/// What the plots show.
struct PlotsState {
    const History* history = nullptr;  ///< never null while panels are drawn
    std::optional<RunFigures> paper;   ///< of what is open, where the paper has it
    PlotView view;
};

}  // namespace kerf::ui
