#include "sim/solve/implicit/step_choice.h"

#include "sim/base/size_params.h"
#include "sim/body/solver_uniforms.h"

namespace kerf {

namespace {

// Of kinetic and strain energy: what is crushed yields, which no measure counts.
constexpr double kGrowth = 0.3;
constexpr double kNoise = 1e-5;    // of the potential energy, which is a sum of floats
constexpr double kMemory = 0.1;    // in which the highest energy is forgotten [s]
constexpr double kLongEnough = 1;  // without growth, until half of the divisions do [s]
constexpr int kMostDivisions = 8;

}  // namespace

std::vector<Bounds> memberBoxes(const BodyModel& model) {
    std::vector<Bounds> boxes(model.members.size());
    for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
        if (const int piece = model.pieceOfVertex[v]; piece >= 0) {
            boxes[model.pieces[piece].member].add(model.restPositions[v].cast<double>());
        }
    }
    return boxes;
}

double longestStep(const BodyModel& model, const Params& params) {
    const std::vector<Bounds> bounds = memberBoxes(model);
    double longest = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < bounds.size(); ++m) {
        if (!bounds[m].empty()) {
            const BodyMember& member = model.members[m];
            longest =
                std::min(longest, longestImplicitStep(bounds[m].diagonal(),
                                                      params.youngsModulus * member.modulus,
                                                      params.density * member.density, params));
        }
    }
    return longest;
}

ImplicitStep ImplicitStep::of(const Params& params, std::size_t vertexCount, double longest) {
    constexpr std::size_t kMany = 5000;  // whose coarse inverse would be larger than the matrix
    ImplicitStep step;
    step.step = params.timeStep / params.implicitSteps;
    step.prepared = params.timeStep / stepsWithin(params.timeStep, longest);
    step.iterations = numberOfIterations(params);
    step.aggregateSize = vertexCount > kMany ? 120 : 60;
    return step;
}

double leastDiagonal(const BodyModel& model) {
    double least = std::numeric_limits<double>::infinity();
    for (const Bounds& box : memberBoxes(model)) {
        least = box.empty() ? least : std::min(least, box.diagonal());
    }
    return least;
}

int stepsWithin(double timeStep, double longest) {
    constexpr double kRounding = 1e-6;
    const double steps = std::ceil(timeStep / longest - kRounding);
    return static_cast<int>(std::clamp<double>(steps, 1, kMostImplicitSteps));
}

double longestStepAt(double speed, double diagonal) {
    constexpr double kOfDiagonal = 0.02;
    return kOfDiagonal * diagonal / std::max(speed, 1e-6);
}

int implicitIterations(const BodyModel& model, double way, double error) {
    constexpr double kStill = 0.002;  // of the diagonal
    constexpr double kSmallError = 0.01;
    constexpr double kMany = 5000;  // vertices, see ImplicitStep::of()
    const double many = static_cast<double>(model.restPositions.size()) / kMany;
    const double larger = std::max(1.0, std::sqrt(many));
    const int more = error < kSmallError ? 2 : 0;
    if (way > kStill) {
        return more + static_cast<int>(std::lround((model.pieces.size() > 1 ? 8 : 6) * larger));
    }
    return more + static_cast<int>(many > 1 ? std::lround(6 * larger) : 4);
}

double energyLeft(double error) {
    constexpr double kOfIterations = 0.25;  // the rest is that of the steps
    return std::pow(kOfIterations * error, 2);
}

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
