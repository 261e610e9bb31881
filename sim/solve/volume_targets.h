#pragma once

#include "sim/body/body_model.h"
#include "sim/solve/solver_pieces.h"

namespace kerf {

/// The target volumes of pieces. The current volume of a piece that has just separated is up to a
/// few per cent off its rest volume, which would be a jump for a rigid constraint; so its target
/// starts there and decays to rest: V0 + (V_now - V0) exp(-t / 0.1 s), by at most 2 V0 a second, so
/// that collapsed or inverted pieces are not ejected. To keep the body's volume meanwhile, all
/// parts of at least a hundredth of it wait for the slowest of them, and for splinters as far as
/// those would change the sum.
class VolumeTargets {
  public:
    /// Sets all targets to the rest volumes.
    void reset(const BodyModel& model);
    /// Follows a cut. `source`: the old piece that each piece comes from, -1 for none (see
    /// LabelChange). A piece that is the only one from an old piece continues as that; the parts of
    /// a split start at `volumes`, their current ones, shape [pieces of after] [m^3], as do open
    /// pieces that have been closed.
    void follow(std::span<const int> source, const BodyModel& after,
                std::span<const double> volumes);
    /// Starts the target of a piece at `volume`, its current one [m^3], while it is not constrained
    /// or is moved as a whole.
    void startAt(int piece, double volume);
    /// Advances by `time` [s]. Returns whether a target changed.
    bool fade(double time);

    std::span<const VolumeTarget> targets() const { return targets_; }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(pieces_, offsets_, targets_, noted_);
    }

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
