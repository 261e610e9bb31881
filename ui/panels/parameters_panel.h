#pragma once

#include <string>
#include <vector>

#include "sim/base/params.h"
#include "ui/state/action.h"
#include "ui/state/parameters_state.h"

namespace kerf::ui {

/// Draws a row per parameter of paramTable(): the four that people turn first on top, the rest
/// under "More". Each answers with a SetParam command.
void drawParameters(const ParametersState& parameters, std::vector<Action>& actions);

/// Draws the rows of what model `model` of the scene, not the first, may have of its own; the
/// others' value is shown where it has none.
void drawOwnParameters(int model, const ParametersState& parameters, std::vector<Action>& actions);

/// A remark about a parameter as things stand, for instance that the iterations are too few for the
/// modulus; "" for none.
std::string remarkOn(const ParamInfo& info, const ParametersState& parameters);

/// The printf format of a slider: decimals that suit the range, and the unit ("%.4f s"). It does
/// not follow the value, since ImGui rounds to it and scales logarithmic sliders by it.
std::string sliderFormat(const ParamInfo& info);

}  // namespace kerf::ui
