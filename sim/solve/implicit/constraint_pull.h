#pragma once

#include "sim/base/math.h"
#include "sim/body/body_model.h"

namespace kerf {

/// Young's modulus of each type of constraints of a body [Pa]; 0: it has none.
using TypeModuli = std::array<double, kConstraintTypes>;

/// What a constraint does to its vertices where they are. Its energy is about
/// stiffness * secant * value^2 / 2.
struct ConstraintPull {
    int count = 0;  ///< of its vertices; 0: it has no direction here and pulls at none
    std::array<std::uint32_t, 4> vertices{};
    std::array<Vec3, 4> gradients;  ///< of its value
    double value = 0;               ///< of a spring [m], of a bend [rad], clamped there
    double stiffness = 0;           ///< 1 / alpha [N/m], of a bend [N m]
    /// The share of the stiffness that holds here: 1, or less where a bend is clamped.
    double secant = 1;
    /// Of a spring that is stretched: force over length, with which it pulls back what moves
    /// across it [N/m]; 0 for others.
    double across = 0;
    Vec3 direction = Vec3::Zero();    ///< of a spring, a unit vector
    std::array<double, 4> weights{};  ///< of a spring: gradient = weight * direction
};

/// `positions`: of all vertices of the body [m]. `modulus`: of the type, times that of the member.
ConstraintPull pullOf(const EdgeConstraint& edge, double modulus, std::span<const Vec3> positions);
ConstraintPull pullOf(const IspcConstraint& ispc, double modulus, std::span<const Vec3> positions);

/// The square of the largest gradient of a bend at rest [1/m^2]; 0: it has none.
double steepnessAtRest(const BendConstraint& bend, std::span<const Vec3f> rest);
/// `steepness`: at rest. Where it has become steeper than shared::kMostSteepness allows it is
/// softer.
ConstraintPull pullOf(const BendConstraint& bend, double modulus, std::span<const Vec3> positions,
                      double steepness);

/// Makes a constraint no firmer than `firmest` over the sum of |grad C|^2 / mass of its vertices,
/// of which those of mass 0 do not move: see shared::kMostFirmness. [1/s^2]
void boundFirmness(ConstraintPull& pull, std::span<const double> masses, double firmest);

/// Calls f(pull) for each constraint of a body that has a modulus. `steepness`: of its bends, by
/// steepnessAtRest().
template <class F>
void forEachPull(const BodyModel& model, const TypeModuli& moduli,
                 std::span<const double> steepness, std::span<const Vec3> positions, F f) {
    forEachType(model, [&](auto row, const auto& constraints) {
        for (std::size_t c = 0; c < constraints.size(); ++c) {
            const double modulus =
                moduli[row.kType] * model.memberOf(verticesOf(constraints[c])[0]).modulus;
            if (!(modulus > 0)) {
                continue;
            }
            if constexpr (row.kType == shared::kBend) {
                f(pullOf(constraints[c], modulus, positions, steepness[c]));
            } else {
                f(pullOf(constraints[c], modulus, positions));
            }
        }
    });
}

/// steepnessAtRest() of all bends of a body.
std::vector<double> bendSteepness(const BodyModel& model);
/// What all constraints of a body that have a modulus do at rest, in the order of forEachPull().
std::vector<ConstraintPull> pullsAtRest(const BodyModel& model, const TypeModuli& moduli);
/// The same, each by boundFirmness().
std::vector<ConstraintPull> boundedPullsAtRest(const BodyModel& model, const TypeModuli& moduli,
                                               std::span<const double> masses, double firmest);
/// Rest positions of all vertices [m].
std::vector<Vec3> restPlaces(const BodyModel& model);

}  // namespace kerf
