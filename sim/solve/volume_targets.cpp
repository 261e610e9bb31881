#include "sim/solve/volume_targets.h"

#include <cassert>

namespace kerf {

namespace {

constexpr double kFadeTime = 0.1;   // [s]
constexpr double kFastestFade = 2;  // rest volumes a second
// Offsets below this share of the rest volume are float noise.
constexpr double kNegligible = 1e-7;

// Of the rest volume of all: smaller pieces go at a pace of their own, so that a splinter that was
// stretched far keeps others waiting only for as much as it holds too much.
constexpr double kNoted = 0.01;

/// What is left of `offset` after `time`, as a share: a piece that holds its volume takes back two
/// rest volumes a second at most.
double ownShare(double offset, const PieceModel& piece, double time) {
    const double soon = std::exp(-time / kFadeTime);
    if (!piece.holdsVolume || offset == 0.0) {
        return soon;
    }
    return std::max(soon, 1 - kFastestFade * piece.restVolume * time / std::abs(offset));
}

}  // namespace

void VolumeTargets::reset(const BodyModel& model) {
    pieces_ = model.pieces;
    offsets_.assign(pieces_.size(), 0.0);
    rebuild();
}

void VolumeTargets::follow(std::span<const int> source, const BodyModel& after,
                           std::span<const double> volumes) {
    assert(volumes.size() == after.pieces.size() && source.size() == after.pieces.size());
    const std::vector<double> oldOffsets = offsets_;
    const std::vector<PieceModel> before = std::exchange(pieces_, after.pieces);
    offsets_.assign(pieces_.size(), 0.0);
    for (std::size_t p = 0; p < offsets_.size(); ++p) {
        const bool only =
            source[p] >= 0 && std::count(source.begin(), source.end(), source[p]) == 1;
        const bool goesOn = only && !(before[source[p]].open && !pieces_[p].open);
        offsets_[p] = goesOn ? oldOffsets[source[p]] : volumes[p] - pieces_[p].restVolume;
    }
    rebuild();
}

void VolumeTargets::startAt(int piece, double volume) {
    const double offset = volume - pieces_[piece].restVolume;
    offsets_[piece] = pieces_[piece].holdsVolume ? offset : 0.0;
    targets_[piece].volume = pieces_[piece].restVolume + offsets_[piece];
}

bool VolumeTargets::fade(double time) {
    if (std::ranges::all_of(offsets_, [](double offset) { return offset == 0.0; })) {
        return false;
    }
    const double common = commonShare(time);
    const double excess = excessOfSplinters(common, time);
    const double waiting = shareAgainst(excess, common);
    for (std::size_t p = 0; p < offsets_.size(); ++p) {
        const double noted = offsets_[p] * excess < 0 ? waiting : common;
        const double left =
            offsets_[p] * (isNoted(p) ? noted : ownShare(offsets_[p], pieces_[p], time));
        const bool negligible = std::abs(left) < kNegligible * std::abs(pieces_[p].restVolume);
        offsets_[p] = negligible ? 0.0 : left;
    }
    rebuild();
    return true;
}

// At a pace of its own for each, the sum that the parts of a crushed body begin with would not be
// kept on the way.
double VolumeTargets::commonShare(double time) const {
    double share = std::exp(-time / kFadeTime);
    for (std::size_t p = 0; p < offsets_.size(); ++p) {
        if (isNoted(p)) {
            share = std::max(share, ownShare(offsets_[p], pieces_[p], time));
        }
    }
    return share;
}

double VolumeTargets::excessOfSplinters(double common, double time) const {
    double excess = 0;
    for (std::size_t p = 0; p < offsets_.size(); ++p) {
        if (pieces_[p].holdsVolume && !isNoted(p)) {
            excess += (ownShare(offsets_[p], pieces_[p], time) - common) * offsets_[p];
        }
    }
    return excess;
}

double VolumeTargets::shareAgainst(double excess, double common) const {
    double against = 0;
    for (std::size_t p = 0; p < offsets_.size(); ++p) {
        if (isNoted(p) && offsets_[p] * excess < 0) {
            against += offsets_[p];
        }
    }
    return against == 0 ? common : std::min(1.0, common - excess / against);
}

bool VolumeTargets::isNoted(std::size_t piece) const {
    return pieces_[piece].holdsVolume && pieces_[piece].restVolume >= noted_;
}

void VolumeTargets::rebuild() {
    targets_.clear();
    double restVolume = 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        restVolume += pieces_[p].holdsVolume ? pieces_[p].restVolume : 0.0;
        targets_.push_back({pieces_[p].restVolume + offsets_[p], pieces_[p].holdsVolume});
    }
    noted_ = kNoted * restVolume;
}

}  // namespace kerf
