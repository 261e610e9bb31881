#pragma once

#include <string>
#include <vector>

#include "sim/base/params.h"
#include "ui/state/action.h"
#include "ui/state/parameters_state.h"

namespace kerf::ui {

/// Draws a row per parameter of paramTable(): the four most used on top, the rest under "More".
/// Each returns a SetParam command.
void drawParameters(const ParametersState& parameters, std::vector<Action>& actions);

/// Draws the per-model parameters of model `model` of the scene, not the first; shows the common
/// value if it has none.
void drawOwnParameters(int model, const ParametersState& parameters, std::vector<Action>& actions);

/// A remark about a parameter at present, such as too few iterations for the modulus; "" for none.
std::string remarkOn(const ParamInfo& info, const ParametersState& parameters);

/// The printf format of a slider: decimals that suit the range, and the unit ("%.4f s"). It does
/// not follow the value, since ImGui rounds to it and scales logarithmic sliders by it.
std::string sliderFormat(const ParamInfo& info);

}  // namespace kerf::ui
