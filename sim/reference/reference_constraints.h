#pragma once

#include <array>
#include <cstdint>

#include "shaders/shared/constraints.h"
#include "sim/reference/reference_solver.h"

namespace kerf {

/// A constraint function, its gradient by each of its N vertices, and its compliance over h^2
/// (the record's geometry times the `compliance` of SolverUniforms), at positions + displacements.
template <std::size_t N>
struct Linearized {
    std::array<std::uint32_t, N> vertices{};
    std::array<Vec3, N> gradient;
    double value = 0;
    double compliance = 0;
    bool valid = false;  ///< false where the constraint has no gradient
};

/// The place where the gradient is taken: shaders/sim/pull_direction.glsl.
enum class Pull {
    asBefore,  ///< at positions, unless it has turned far meanwhile
    asNow      ///< at positions + displacements
};

/// C = length - rest length.
Linearized<2> linearize(const EdgeConstraint& c, const ReferenceState& s, double compliance,
                        Pull pull);
/// C = angle - rest angle, wrapped, then clamped to kMaxBendError.
Linearized<4> linearize(const BendConstraint& c, const ReferenceState& s, double compliance,
                        Pull pull);
/// C = distance from the vertex to the point on the opposite side - rest length.
Linearized<4> linearize(const shared::IspcConstraint& c, const ReferenceState& s, double compliance,
                        Pull pull);

}  // namespace kerf
