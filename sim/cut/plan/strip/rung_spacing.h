#pragma once

#include <vector>

#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

struct StripNode;

/// The lengths wanted for the edges of a new rung: those around at the ends of the front, where the
/// rim is, longer away from them (WallGrading), and no longer than the row of the wall is high.
class RungSpacing {
  public:
    /// As the edges around.
    RungSpacing() = default;
    /// `oldRung`: the nodes from which the step leads to the blade.
    RungSpacing(const StepInput& in, const std::vector<StripNode>& oldRung);
    /// The length wanted at parameter s of the blade, where edges are `edge` long [m].
    double at(double s, double edge) const;

  private:
    struct Place {
        double s;
        double fromRim;  ///< distance along the front to its nearer end; 0 outside [m]
        double height;   ///< of the row [m]
    };
    std::vector<Place> places_;  ///< nodes of the old rung; none where nothing grows
    WallGrading grading_;
};

}  // namespace kerf::cut
