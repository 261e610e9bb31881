#pragma once

#include <tuple>

#include "sim/body/constraint_lists.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {

/// A constraint function and its gradient by each of its N vertices, at positions + displacements.
template <std::size_t N>
struct Linearized {
    std::array<std::uint32_t, N> vertices{};
    std::array<Vec3, N> gradient;
    double value = 0;
    bool valid = false;  ///< false where the constraint has no gradient
};

/// A constraint of a type, with as many vertices as it has.
template <class Constraint>
using LinearizedOf = Linearized<std::tuple_size_v<decltype(verticesOf(Constraint{}))>>;

// A function for each row of constraints.h.
#define KERF_LINEARIZE(number, Name, list, Constraint, Gather) \
    LinearizedOf<Constraint> linearize(const Constraint& c, const ReferenceState& s);
KERF_CONSTRAINTS(KERF_LINEARIZE)
#undef KERF_LINEARIZE

/// The energy that BodyMeasure::strainEnergy is compared with [J]: the sum of C^2 E / (2 geometry)
/// over the constraints that are on and not rigid, beyond the clamp of a bend with constant moment.
double strainEnergy(const BodyModel& model, const shared::SolverUniforms& uniforms,
                    const ReferenceState& state);

}  // namespace kerf
