#pragma once

#include "sim/mesh/invariants.h"

namespace kerf::app {

/// Watches a run for pieces that lose their volume: flat ones, or inverted ones with a negative
/// volume, which the volume of the whole body may hide.
class VolumeWatch {
  public:
    /// Adds the pieces after a step, while no wound is open. Ignores debris. Returns whether a
    /// piece was flat or inverted for the first time.
    bool add(int step, const std::vector<Piece>& pieces);
    /// One sentence on the first time, the volume and what to do; "" if it did not happen.
    std::string sentence() const;

  private:
    struct Lost {
        int step = 0;
        int pieces = 0;    ///< in all
        double ratio = 0;  ///< volume over that at rest, the least of any piece
    };

    std::optional<Lost> first_;  ///< of those inside out, if there are any
    int lostSteps_ = 0;
};

}  // namespace kerf::app
