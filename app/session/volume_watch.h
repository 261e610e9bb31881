#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/mesh/invariants.h"

namespace kerf::app {

/// Watches over a run for pieces that turn inside out: their volume becomes negative, which a
/// volume of the whole body may hide.
class VolumeWatch {
  public:
    /// Takes note of the pieces after a step, while no wound is open. Debris does not count.
    /// Returns whether the first piece turned in this step.
    bool add(int step, const std::vector<Piece>& pieces);
    /// One sentence on when it first happened, what the volume was and what to do; "" where it did
    /// not happen.
    std::string sentence() const;

  private:
    struct Turned {
        int step = 0;
        int pieces = 0;    ///< there were in all
        double ratio = 0;  ///< volume over that at rest, the least of any piece
    };

    std::optional<Turned> first_;
    int turnedSteps_ = 0;
};

}  // namespace kerf::app
