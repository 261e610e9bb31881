#pragma once

#include <vector>

#include "ui/state/action.h"
#include "ui/state/model_state.h"
#include "ui/state/parameters_state.h"

namespace kerf::ui {

/// Draws the open model's unit, up axis, rotation and scale, which a click or a drag changes, and
/// the physics of its size.
void drawModel(const ModelPanelState& model, const ParametersState& parameters,
               const DisplaySettings& display, std::vector<Action>& actions);

}  // namespace kerf::ui
