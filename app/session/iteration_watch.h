#pragma once

#include <string>

#include "sim/base/params.h"
#include "sim/body/body_model.h"
#include "sim/solve/sweep_strength.h"

namespace kerf::app {

/// Watches over a run for steps with too few sweeps for the stiffness (sim/solve/sweep_strength.h),
/// which make a body softer than its modulus without any other sign of it.
class IterationWatch {
  public:
    /// Takes note of a step that runs with this body and these parameters.
    void add(int step, const BodyModel& body, const Params& params);
    /// One sentence on what is too few, where it is worst and what to do; "" where no step had too
    /// few.
    std::string sentence() const;

  private:
    SweepStrength strength_;
    int steps_ = 0;
    int weakSteps_ = 0;
    double least_ = 1;  ///< SweepStrength::carried()
    int worstStep_ = 0;
    Params worst_;
};

}  // namespace kerf::app
