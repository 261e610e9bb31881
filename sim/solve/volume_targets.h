#pragma once

#include <span>
#include <vector>

#include "sim/body/body_model.h"
#include "sim/solve/solver_pieces.h"

namespace kerf {

/// The volumes at which pieces are held. A piece that has just come off has a current volume up to
/// a few per cent off its rest volume, which a rigid constraint would take as a jump; so its target
/// starts where it is and fades to rest: V0 + (V_now - V0) exp(-t / 0.1 s). A piece comes back by
/// 2 V0 a second at most, so that what has collapsed or turned inside out is not shot off. So that
/// the parts keep the body's volume on the way, all of at least a hundredth of it wait for the
/// slowest of them, and for splinters as far as those would change the sum.
class VolumeTargets {
  public:
    /// Holds all pieces at their rest volumes.
    void reset(const BodyModel& model);
    /// Follows a cut. `source`: the old piece that each piece comes from, -1 for none (see
    /// LabelChange). A piece that is the only one left of an old piece goes on as that; the parts
    /// of a split start at `volumes`, their current ones, shape [pieces of after] [m^3], and so do
    /// open pieces that have been closed.
    void follow(std::span<const int> source, const BodyModel& after,
                std::span<const double> volumes);
    /// Lets targets start at `volumes` while volumes are not held: the current ones, shape
    /// [pieces].
    void startAt(std::span<const double> volumes);
    /// Lets `time` [s] pass. Returns whether a target changed.
    bool fade(double time);

    std::span<const VolumeTarget> targets() const { return targets_; }

  private:
    /// The share that may be left of the offsets of noted pieces.
    double commonShare(double time) const;
    /// The volume by which splinters will be off beyond that share, together [m^3].
    double excessOfSplinters(double common, double time) const;
    /// The share to be left of noted offsets of the other sign, so that the sum is kept.
    double shareAgainst(double excess, double common) const;
    bool isNoted(std::size_t piece) const;  ///< holds its volume and is no splinter
    void rebuild();

    std::vector<PieceModel> pieces_;
    std::vector<double> offsets_;  ///< target minus rest volume, per piece [m^3]
    std::vector<VolumeTarget> targets_;
    double noted_ = 0;  ///< rest volume of the smallest piece that is no splinter [m^3]
};

}  // namespace kerf
