#include "sim/solve/implicit/energy_guard.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf {

namespace {

constexpr double kGrowth = 0.05;  // of kinetic and strain energy: contacts give back what they took
constexpr double kNoise = 1e-5;   // of the potential energy, which is a sum of floats
constexpr double kMemory = 0.1;   // in which the highest energy is forgotten [s]
constexpr double kLongEnough = 1;  // without growth, until half of the divisions do [s]
constexpr int kMostDivisions = 8;

}  // namespace

bool EnergyGuard::note(const BodyEnergies& body, double h, bool worked, double least) {
    const double energy = body.moving + body.potential;
    const double noise = std::max(least, kNoise * std::abs(body.potential));
    const double most = highest_ + kGrowth * body.moving + noise;
    const bool mayGrow = std::exchange(isNew_, false) || worked;
    const bool grew = !mayGrow && energy > most;
    const double kept = std::max(0.0, highest_ - energy) * std::exp(-h / kMemory);
    highest_ = grew || mayGrow ? energy : energy + kept;
    calm_ = grew ? 0 : calm_ + h;
    if (calm_ >= kLongEnough) {
        divisions_ = std::max(1, divisions_ / 2);
        calm_ = 0;
    }
    const int before = divisions_;
    divisions_ = grew ? std::min(kMostDivisions, 2 * divisions_) : divisions_;
    return divisions_ > before;
}

}  // namespace kerf
