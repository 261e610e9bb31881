#pragma once

#include <optional>

#include "sim/base/params.h"

namespace kerf::ui {

/// What the panel of parameters shows.
struct ParametersState {
    Params now;
    Params start;                    ///< when opened, for the reset button
    int iterations = 1;              ///< of the last step, as given or chosen
    int implicitSteps = 0;           ///< that the last step was made of; 0 while nothing is open
    std::optional<double> residual;  ///< of it: see StepParts
};

}  // namespace kerf::ui
