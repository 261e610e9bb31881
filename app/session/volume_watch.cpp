#include "app/session/volume_watch.h"

#include <spdlog/fmt/fmt.h>

namespace kerf::app {

namespace {

constexpr double kDebris = 1e-4;  // of the body: smaller pieces have no volume constraint either
constexpr double kFlat = 0.02;    // of its volume at rest: the body has no thickness to speak of

/// The least ratio of volume to that at rest; debris left out.
double leastRatio(const std::vector<Piece>& pieces) {
    const double body =
        std::accumulate(pieces.begin(), pieces.end(), 0.0,
                        [](double sum, const Piece& piece) { return sum + piece.restVolume; });
    double least = std::numeric_limits<double>::max();
    for (const Piece& piece : pieces) {
        if (piece.restVolume > kDebris * body) {
            least = std::min(least, piece.volume / piece.restVolume);
        }
    }
    return least;
}

}  // namespace

bool VolumeWatch::add(int step, const std::vector<Piece>& pieces) {
    const double least = leastRatio(pieces);
    if (least >= kFlat) {
        return false;
    }
    ++lostSteps_;
    const bool isNew = !first_ || (first_->ratio >= 0 && least < 0);
    if (isNew) {
        first_ = Lost{step, static_cast<int>(pieces.size()), least};
    }
    return isNew;
}

std::string VolumeWatch::sentence() const {
    if (!first_) {
        return "";
    }
    const std::string more =
        lostSteps_ > 1 ? fmt::format(" It was so in {} steps.", lostSteps_) : "";
    return fmt::format(
        "Step {}: {} {}, with {:.1f} % of its volume at rest. Its shape and all volumes from here "
        "on mean little; a higher ispc_stiffness or more iterations hold it up.{}",
        first_->step, first_->pieces == 1 ? "the body" : "a piece",
        first_->ratio < 0 ? "turned inside out" : "was pressed flat", 100 * first_->ratio, more);
}

}  // namespace kerf::app
