#pragma once

#include <vector>

#include "sim/run/parts/running_body.h"
#include "sim/solve/front_anchors.h"

namespace kerf {

/// Holds the front of an unfinished slit for a step, until release(); where walls are absent, as in
/// the open course, what is hidden follows the body instead. See findFrontAnchors().
class FrontHold {
  public:
    /// The body must outlive it. `timeStep`: the coming one [s].
    FrontHold(RunningBody& body, double timeStep);
    void release();

  private:
    AnchorFrame frame(double timeStep) const;
    void carryHidden(double timeStep);

    RunningBody& body_;
    std::vector<Anchor> anchors_;
};

}  // namespace kerf
