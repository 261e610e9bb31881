#include "app/scene/document/size_effect.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"

namespace kerf::app {
namespace {

// Pressure of the weight at the foot, of Young's modulus.
constexpr double kCollapses = 0.5;
constexpr double kSags = 0.05;

constexpr double kStepsOfAFall = 5;  // through the own height: fewer are no motion to look at

/// With one digit that counts: "400 kPa".
std::string pascals(double value) {
    const double digit = std::pow(10, std::floor(std::log10(value)));
    const bool kilo = value < 1e6;
    return fmt::format("{:g} {}", digit * std::round(value / digit) / (kilo ? 1e3 : 1e6),
                       kilo ? "kPa" : "MPa");
}

/// How the weight of a column of this height bears on its foot.
std::string underItsWeight(double height, double pressure, double modulus) {
    const double load = pressure / modulus;
    if (load > kCollapses) {
        return " It will collapse under its own weight. Use a smaller unit, or raise Young's "
               "modulus to about " +
               pascals(pressure / kSags) + ".";
    }
    if (load > kSags) {
        return " It will sag by about " + lengthText(0.5 * load * height) + ".";
    }
    return " It holds its shape.";
}

}  // namespace

std::string sizeEffect(double height, double volume, const Params& params) {
    const double gravity = params.gravity.norm();
    const std::string weight =
        "Weighs " + massText(params.density * std::fabs(volume)) + " at this size.";
    if (gravity == 0) {
        return weight + " Gravity is off, so nothing falls.";
    }
    const double fall = std::sqrt(2 * height / gravity);
    if (fall < kStepsOfAFall * params.timeStep) {
        return weight +
               " It is so small that it falls its own height within a few steps. Use a shorter "
               "time step or a larger unit to see more.";
    }
    return weight + underItsWeight(height, params.density * gravity * height, params.youngsModulus);
}

}  // namespace kerf::app
