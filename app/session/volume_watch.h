#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/mesh/invariants.h"

namespace kerf::app {

/// Watches over a run for pieces that lose their volume: they are pressed flat, or turn inside out
/// and have a negative one, which a volume of the whole body may hide.
class VolumeWatch {
  public:
    /// Takes note of the pieces after a step, while no wound is open. Debris does not count.
    /// Returns whether a piece was pressed flat or turned inside out for the first time.
    bool add(int step, const std::vector<Piece>& pieces);
    /// One sentence on when it first happened, what the volume was and what to do; "" where it did
    /// not happen.
    std::string sentence() const;

  private:
    struct Lost {
        int step = 0;
        int pieces = 0;    ///< there were in all
        double ratio = 0;  ///< volume over that at rest, the least of any piece
    };

    std::optional<Lost> first_;  ///< of those inside out, if there are any
    int lostSteps_ = 0;
};

}  // namespace kerf::app
