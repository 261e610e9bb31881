#pragma once

#include <optional>
#include <vector>

#include "ui/action.h"
#include "ui/history.h"
#include "ui/plot.h"
#include "ui/transport_panel.h"

namespace kerf::ui {

/// What the plots show.
struct PlotsState {
    const History* history = nullptr;  ///< never null while panels are drawn
    std::optional<RunFigures> paper;   ///< of what is open, where the paper has it
    PlotView view;
};

/// The plots that are chosen in the settings. What they point to lives as long as the model.
std::vector<PlotSpec> chosenPlots(const PlotsState& state, const Settings& settings);

/// Draws a line of buttons and the chosen plots, together `height` pixels high; they scroll where
/// they would get too small to read.
void drawPlots(const PlotsState& state, const TransportState& transport, const Settings& settings,
               float height, std::vector<Action>& actions);

}  // namespace kerf::ui
