#include "sim/solve/implicit/step_choice.h"

#include <algorithm>
#include <cmath>

namespace kerf {

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
    constexpr double kOfWave = 0.65;
    constexpr double kShortest = 1.0 / 240;
    constexpr double kLongest = 1.0 / 60;
    const std::vector<Bounds> bounds = memberBoxes(model);
    double longest = kLongest;
    for (std::size_t m = 0; m < bounds.size(); ++m) {
        if (!bounds[m].empty()) {
            const BodyMember& member = model.members[m];
            const double wave = std::sqrt(params.youngsModulus * member.modulus /
                                          (params.density * member.density));
            longest = std::min(longest, kOfWave * bounds[m].diagonal() / wave);
        }
    }
    return std::max(longest, kShortest);
}

int stepsWithin(double timeStep, double longest) {
    constexpr double kRounding = 1e-6;
    return std::max(1, static_cast<int>(std::ceil(timeStep / longest - kRounding)));
}

double longestStepAt(double speed, double diagonal) {
    constexpr double kOfDiagonal = 0.02;
    return kOfDiagonal * diagonal / std::max(speed, 1e-6);
}

int implicitIterations(const BodyModel& model, double way) {
    constexpr double kStill = 0.002;     // of the diagonal
    constexpr std::size_t kMany = 5000;  // vertices, see ImplicitStep::of()
    if (way > kStill * model.diagonal) {
        return model.pieces.size() > 1 ? 8 : 6;
    }
    return model.restPositions.size() > kMany ? 6 : 4;
}

}  // namespace kerf
