#include "app/scene/document/size_effect.h"

#include <cmath>
#include <cstdio>

#include "sim/base/quantity_text.h"

namespace kerf::app {
namespace {

// Pressure of the weight at the foot, of Young's modulus.
constexpr double kCollapses = 0.5;
constexpr double kSags = 0.05;

constexpr double kStepsOfAFall = 5;  // through the own height: fewer are no motion to look at

std::string pascals(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1g Pa", value);
    return text;
}

/// How the weight of a column of this height bears on its foot.
std::string underItsWeight(double height, double pressure, double modulus) {
    const double load = pressure / modulus;
    if (load > kCollapses) {
        return " That is too much for it: it sinks flat. A smaller unit, or a Young's modulus of " +
               pascals(pressure / kSags) + ", would carry it.";
    }
    if (load > kSags) {
        return " It sags by about " + lengthText(0.5 * load * height) + ".";
    }
    return " It keeps its shape.";
}

}  // namespace

std::string sizeEffect(double height, double volume, const Params& params) {
    const double gravity = params.gravity.norm();
    const std::string weight = lengthText(height) + " of this material weighs " +
                               massText(params.density * std::fabs(volume)) + ".";
    if (gravity == 0) {
        return weight + " Without gravity nothing falls.";
    }
    const double fall = std::sqrt(2 * height / gravity);
    if (fall < kStepsOfAFall * params.timeStep) {
        return weight +
               " It is so small that it falls its own height within a few steps: a shorter"
               " time step or a larger unit shows more.";
    }
    return weight + underItsWeight(height, params.density * gravity * height, params.youngsModulus);
}

}  // namespace kerf::app
