#pragma once

#include <vector>

#include "ui/plots/plot.h"
#include "ui/state/action.h"
#include "ui/state/plots_state.h"
#include "ui/state/transport_state.h"

namespace kerf::ui {

/// The plots chosen in the settings. They refer to the model.
std::vector<PlotSpec> chosenPlots(const PlotsState& state, const Settings& settings);

/// Draws a line of buttons and the chosen plots, together `height` pixels high; they scroll where
/// they would get too small to read.
void drawPlots(const PlotsState& state, const TransportState& transport, const Settings& settings,
               float height, std::vector<Action>& actions);

}  // namespace kerf::ui
