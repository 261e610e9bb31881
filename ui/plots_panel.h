#pragma once

#include <string_view>
#include <vector>

#include "ui/action.h"
#include "ui/panel_model.h"
#include "ui/plot.h"

namespace kerf::ui {

/// A plot that can be chosen.
struct PlotKind {
    const char* id;  ///< its name in Settings::plots and in files
    const char* title;
};
/// All of them, in their order on the screen.
std::span<const PlotKind> plotKinds();

/// The plots that are chosen in the settings. What they point to lives as long as the model.
std::vector<PlotSpec> chosenPlots(const PanelModel& model);

/// A line of buttons and the chosen plots, together `height` pixels high; they scroll where they
/// would get too small to read.
void drawPlots(const PanelModel& model, float height, std::vector<Action>& actions);

}  // namespace kerf::ui
