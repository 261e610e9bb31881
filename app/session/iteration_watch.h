#pragma once

#include <string>

#include "sim/base/params.h"
#include "sim/body/body_model.h"
#include "sim/solve/sweep_strength.h"

namespace kerf::app {

/// Watches a run for steps with too few sweeps for the stiffness (sim/solve/sweep_strength.h),
/// which silently make a body softer than its modulus.
class IterationWatch {
  public:
    /// Adds a step with this body and these parameters.
    void add(int step, const BodyModel& body, const Params& params);
    /// One sentence on the worst step and what to do; "" if no step had too few.
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
