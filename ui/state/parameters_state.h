#pragma once

#include "sim/base/params.h"

namespace kerf {
class SweepStrength;
}

namespace kerf::ui {

/// What the panel of parameters shows.
struct ParametersState {
    Params now;
    Params start;                           ///< when opened, for the reset button
    int iterations = 1;                     ///< of the last step, as given or chosen
    int implicitSteps = 1;                  ///< that the last step was made of
    const SweepStrength* sweeps = nullptr;  ///< of the body; null while nothing is open
};

}  // namespace kerf::ui
