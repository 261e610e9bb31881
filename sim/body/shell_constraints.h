#pragma once

#include <cstdint>

namespace kerf {

/// A stretching constraint: C = |p_a - p_b| - rest_length, compliance alpha = geometry / E_stretch
/// with geometry = L^2 / (t (A1 + A2)). The solver reads it as two Spokes.
struct EdgeConstraint {
    std::uint32_t a;
    std::uint32_t b;
    float rest_length;  ///< [m]
    float geometry;     ///< [1/m]
};

/// A bending constraint: C is the signed dihedral angle of the edge v0 v1 with apexes v2 (left) and
/// v3 (right), flat 0, convex > 0, less the rest angle. Compliance alpha = geometry / E_bend with
/// geometry = 1 / (0.3 t^3 / 12). The solver reads it as a BendRecord.
struct BendConstraint {
    std::uint32_t v0;
    std::uint32_t v1;
    std::uint32_t v2;
    std::uint32_t v3;
    float rest_angle;  ///< [rad]
    float geometry;    ///< [1/m^3]
};

}  // namespace kerf
