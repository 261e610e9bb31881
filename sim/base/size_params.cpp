#include "sim/base/size_params.h"

#include <algorithm>
#include <initializer_list>

namespace kerf {
namespace {

constexpr double kEarthGravity = 9.81;  // [m/s^2]
constexpr double kMostFall = 0.0005;    // of the diagonal, in the first step of a free fall
constexpr double kFastestWay = 0.02;    // of the diagonal, in a step
constexpr double kSlowestSpeed = 0.1;   // diagonals a second
constexpr auto kTimeSteps = {0.002, 0.001, 0.0005};
constexpr auto kSpeeds = {10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01};

double timeStepFor(double diagonal) {
    const double most = kMostFall * diagonal / kEarthGravity;  // of its square
    double timeStep = Params{}.timeStep;
    for (const double shorter : kTimeSteps) {
        timeStep = timeStep * timeStep > most ? shorter : timeStep;
    }
    return timeStep;
}

double speedFor(double diagonal, double timeStep) {
    const double most = std::max(Params{}.depenetrationSpeed, kSlowestSpeed * diagonal);
    const double wanted = std::min(most, kFastestWay * diagonal / timeStep);
    const auto* const found =
        std::ranges::find_if(kSpeeds, [&](double speed) { return speed <= wanted; });
    return found == kSpeeds.end() ? *(kSpeeds.end() - 1) : *found;
}

}  // namespace

Params suitedTo(double diagonal, Params params) {
    params.timeStep = timeStepFor(diagonal);
    params.depenetrationSpeed = speedFor(diagonal, params.timeStep);
    return params;
}

Params followSize(double before, double after, Params params) {
    const Params then = suitedTo(before, params);
    const Params now = suitedTo(after, params);
    if (params.timeStep == then.timeStep) {
        params.timeStep = now.timeStep;
    }
    if (params.depenetrationSpeed == then.depenetrationSpeed) {
        params.depenetrationSpeed = now.depenetrationSpeed;
    }
    return params;
}

}  // namespace kerf
