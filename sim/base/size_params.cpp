#include "sim/base/size_params.h"

#include <initializer_list>

namespace kerf {
namespace {

constexpr double kEarthGravity = 9.81;  // [m/s^2]
constexpr double kMostFall = 0.03;      // of the diagonal, in the first step of a free fall
constexpr double kMostOfPbd = 0.0005;   // the same with pbd
constexpr double kFastestWay = 4;       // diagonals a second
constexpr double kSlowestSpeed = 0.1;   // diagonals a second
constexpr auto kTimeSteps = {0.016, 0.008, 0.005, 0.004, 0.002, 0.001, 0.0005};
constexpr auto kSpeeds = {10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01};

double timeStepFor(double diagonal, const Params& params) {
    const bool isPbd = params.solver == SolverMode::pbd;
    const double fall = (isPbd ? kMostOfPbd : kMostFall) * diagonal;
    const double material =
        isPbd ? Params{}.timeStep
              : longestImplicitStep(diagonal, params.youngsModulus, params.density, params);
    const double most = std::min(material, std::sqrt(fall / kEarthGravity));
    const auto* const found =
        std::ranges::find_if(kTimeSteps, [&](double step) { return step <= most; });
    return found == kTimeSteps.end() ? *(kTimeSteps.end() - 1) : *found;
}

double speedFor(double diagonal) {
    const double most = std::max(Params{}.depenetrationSpeed, kSlowestSpeed * diagonal);
    const double wanted = std::min(most, kFastestWay * diagonal);
    const auto* const found =
        std::ranges::find_if(kSpeeds, [&](double speed) { return speed <= wanted; });
    return found == kSpeeds.end() ? *(kSpeeds.end() - 1) : *found;
}

}  // namespace

double longestImplicitStep(double diagonal, double modulus, double density, const Params& params) {
    constexpr double kOfWave = 0.65;
    constexpr double kShortest = 0.005;
    constexpr double kLongest = 1.0 / 60;
    constexpr double kUsualError = 0.02;
    const double crossing = diagonal * std::sqrt(density / modulus);
    const double careful = std::min(1.0, std::sqrt(params.iterationError / kUsualError));
    return careful * std::clamp(kOfWave * crossing, kShortest, kLongest);
}

Params suitedTo(double diagonal, Params params) {
    params.timeStep = timeStepFor(diagonal, params);
    params.depenetrationSpeed = speedFor(diagonal);
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
