#include "tests/support/reference/reference_constraints.h"

#include "sim/body/rest_geometry.h"

namespace kerf {

namespace {

constexpr double kShortestLength = 1e-12;  // [m]; a shorter segment has no direction

/// p_i - p_j as (X_i - X_j) + (d_i - d_j).
Vec3 difference(const ReferenceState& s, std::uint32_t i, std::uint32_t j) {
    return (s.positions[i] - s.positions[j]) + (s.displacements[i] - s.displacements[j]);
}

Dihedral<double> angleOf(const BendConstraint& bend, const ReferenceState& s) {
    return dihedral<double>(difference(s, bend.v1, bend.v0), difference(s, bend.v2, bend.v0),
                            difference(s, bend.v3, bend.v0));
}

double squareFor(const BendConstraint& bend, const ReferenceState& state) {
    const auto angle = angleOf(bend, state);
    if (!angle.valid) {
        return 0;
    }
    const double error = std::fabs(wrapAngle(angle.angle - bend.rest_angle));
    const double elastic = std::min(error, static_cast<double>(shared::kMaxBendError));
    return elastic * (2 * error - elastic);
}

template <class Spring>
double squareFor(const Spring& spring, const ReferenceState& state) {
    const double error = linearize(spring, state).value;
    return error * error;
}

template <class Constraint>
double sumOver(const BodyModel& model, const std::vector<Constraint>& constraints, double modulus,
               const ReferenceState& state) {
    double sum = 0;
    for (const Constraint& constraint : constraints) {
        const double stiffness =
            modulus * model.memberOf(verticesOf(constraint)[0]).modulus / constraint.geometry;
        sum += constraint.geometry > 0 ? 0.5 * squareFor(constraint, state) * stiffness : 0;
    }
    return sum;
}

}  // namespace

/// C = length - rest length.
Linearized<2> linearize(const EdgeConstraint& c, const ReferenceState& s) {
    Linearized<2> result{verticesOf(c), {}, 0, false};
    const Vec3 r = difference(s, c.a, c.b);
    const double length = r.norm();
    if (length > kShortestLength) {
        const Vec3 n = r / length;
        result.valid = true;
        result.value = length - c.rest_length;
        result.gradient = {n, -n};
    }
    return result;
}

/// C = angle - rest angle, wrapped, then clamped to kMaxBendError.
Linearized<4> linearize(const BendConstraint& c, const ReferenceState& s) {
    Linearized<4> result{verticesOf(c), {}, 0, false};
    const auto angle = angleOf(c, s);
    if (angle.valid) {
        const double limit = shared::kMaxBendError;
        result.valid = true;
        result.value = std::clamp(wrapAngle(angle.angle - c.rest_angle), -limit, limit);
        result.gradient = angle.gradient;
    }
    return result;
}

/// C = distance from the vertex to the point on the opposite side - rest length.
Linearized<4> linearize(const shared::IspcConstraint& c, const ReferenceState& s) {
    Linearized<4> result{verticesOf(c), {}, 0, false};
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

double strainEnergy(const BodyModel& model, const shared::SolverUniforms& uniforms,
                    const ReferenceState& state) {
    double sum = 0;
    forEachType(model, [&](auto row, const auto& constraints) {
        const bool on = (uniforms.active_parts >> row.kType & 1u) != 0;
        sum += on ? sumOver(model, constraints, uniforms.modulus[row.kType], state) : 0;
    });
    return sum;
}

}  // namespace kerf
