#include "sim/solve/reference_constraints.h"

#include <algorithm>

#include "sim/body/dihedral.h"
#include "sim/body/incidence.h"

namespace kerf {

namespace {

constexpr double kShortestLength = 1e-12;  // [m]; a shorter segment has no direction

/// p_i - p_j as (X_i - X_j) + (d_i - d_j).
Vec3 difference(const ReferenceState& s, std::uint32_t i, std::uint32_t j) {
    return (s.positions[i] - s.positions[j]) + (s.displacements[i] - s.displacements[j]);
}

}  // namespace

Linearized<2> linearize(const shared::EdgeConstraint& c, const ReferenceState& s,
                        double compliance) {
    Linearized<2> result{verticesOf(c), {}, 0, c.geometry * compliance, false};
    const Vec3 r = difference(s, c.a, c.b);
    const double length = r.norm();
    if (length > kShortestLength) {
        result.valid = true;
        result.value = length - c.rest_length;
        result.gradient = {r / length, -r / length};
    }
    return result;
}

Linearized<4> linearize(const shared::BendConstraint& c, const ReferenceState& s,
                        double compliance) {
    Linearized<4> result{verticesOf(c), {}, 0, c.geometry * compliance, false};
    const auto angle = dihedral<double>(difference(s, c.v1, c.v0), difference(s, c.v2, c.v0),
                                        difference(s, c.v3, c.v0));
    if (angle.valid) {
        const double limit = shared::kMaxBendError;
        result.valid = true;
        result.value = std::clamp(wrapAngle(angle.angle - c.rest_angle), -limit, limit);
        result.gradient = angle.gradient;
    }
    return result;
}

Linearized<4> linearize(const shared::IspcConstraint& c, const ReferenceState& s,
                        double compliance) {
    Linearized<4> result{verticesOf(c), {}, 0, c.geometry * compliance, false};
    const double b1 = c.b1;
    const double b2 = c.b2;
    const double b0 = 1 - b1 - b2;
    const Vec3 r = b0 * difference(s, c.vertex, c.t0) + b1 * difference(s, c.vertex, c.t1) +
                   b2 * difference(s, c.vertex, c.t2);
    const double length = r.norm();
    if (length > kShortestLength) {
        const Vec3 n = r / length;
        result.valid = true;
        result.value = length - c.rest_length;
        result.gradient = {n, -b0 * n, -b1 * n, -b2 * n};
    }
    return result;
}

}  // namespace kerf
