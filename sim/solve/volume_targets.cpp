#include "sim/solve/volume_targets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace kerf {

namespace {

constexpr double kFadeTime = 0.1;   // [s]
constexpr double kFastestFade = 2;  // rest volumes a second
// Offsets below this share of the rest volume are float noise.
constexpr double kNegligible = 1e-7;

double faded(double offset, const PieceModel& piece, double time) {
    const double least = std::abs(offset) - kFastestFade * piece.restVolume * time;
    const double soon = offset * std::exp(-time / kFadeTime);
    const bool tooSoon = piece.holdsVolume && std::abs(soon) < least;
    const double rest = tooSoon ? std::copysign(least, offset) : soon;
    return std::abs(rest) < kNegligible * std::abs(piece.restVolume) ? 0.0 : rest;
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

void VolumeTargets::startAt(std::span<const double> volumes) {
    assert(volumes.size() == pieces_.size());
    for (std::size_t p = 0; p < offsets_.size(); ++p) {
        offsets_[p] = pieces_[p].holdsVolume ? volumes[p] - pieces_[p].restVolume : 0.0;
    }
    rebuild();
}

bool VolumeTargets::fade(double time) {
    bool changed = false;
    for (std::size_t p = 0; p < offsets_.size(); ++p) {
        if (offsets_[p] != 0.0) {
            offsets_[p] = faded(offsets_[p], pieces_[p], time);
            changed = true;
        }
    }
    if (changed) {
        rebuild();
    }
    return changed;
}

void VolumeTargets::rebuild() {
    targets_.clear();
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        targets_.push_back({pieces_[p].restVolume + offsets_[p], pieces_[p].holdsVolume});
    }
}

}  // namespace kerf
