#include "tests/support/reference/reference_constraints.h"

#include <algorithm>
#include <cmath>

#include "sim/body/dihedral.h"

namespace kerf {

namespace {

constexpr double kShortestLength = 1e-12;  // [m]; a shorter segment has no direction

/// X_i - X_j.
Vec3 differenceBefore(const ReferenceState& s, std::uint32_t i, std::uint32_t j) {
    return s.positions[i] - s.positions[j];
}

/// p_i - p_j as (X_i - X_j) + (d_i - d_j).
Vec3 difference(const ReferenceState& s, std::uint32_t i, std::uint32_t j) {
    return differenceBefore(s, i, j) + (s.displacements[i] - s.displacements[j]);
}

/// In the substep it turned by no more than 60 degrees and kept half of its size.
bool turnedLittle(const Vec3& before, const Vec3& now) {
    return before.dot(now) > 0.5 * std::max(before.squaredNorm(), now.squaredNorm());
}

/// Direction to pull in: as at the beginning of the substep where that still fits.
Vec3 pullDirection(Pull pull, const Vec3& before, const Vec3& now) {
    return pull == Pull::asBefore && turnedLittle(before, now) ? before.normalized()
                                                               : now.normalized();
}

/// From x0 to the others.
struct Wings {
    Vec3 edge, left, right;

    Dihedral<double> angle() const { return dihedral<double>(edge, left, right); }
    bool turnedLittleTo(const Wings& now) const {
        return turnedLittle(edge, now.edge) &&
               turnedLittle(edge.cross(left), now.edge.cross(now.left)) &&
               turnedLittle(right.cross(edge), now.right.cross(now.edge));
    }
};

double squareFor(const BendConstraint& bend, const ReferenceState& state) {
    const auto from = [&](std::uint32_t v) {
        return Vec3(state.positions[v] + state.displacements[v] - state.positions[bend.v0] -
                    state.displacements[bend.v0]);
    };
    const auto angle = dihedral<double>(from(bend.v1), from(bend.v2), from(bend.v3));
    if (!angle.valid) {
        return 0;
    }
    const double error = std::fabs(wrapAngle(angle.angle - bend.rest_angle));
    const double elastic = std::min(error, static_cast<double>(shared::kMaxBendError));
    return elastic * (2 * error - elastic);
}

template <class Spring>
double squareFor(const Spring& spring, const ReferenceState& state) {
    const double error = linearize(spring, state, 0, Pull::asNow).value;
    return error * error;
}

template <class Constraint>
double sumOver(const BodyModel& model, const std::vector<Constraint>& constraints,
               double compliance, const ReferenceState& state) {
    double sum = 0;
    for (const Constraint& constraint : constraints) {
        const double modulus = model.memberOf(verticesOf(constraint)[0]).modulus;
        const double alpha = constraint.geometry * compliance / modulus;
        sum += alpha > 0 ? 0.5 * squareFor(constraint, state) / alpha : 0;
    }
    return sum;
}

}  // namespace

/// C = length - rest length.
Linearized<2> linearize(const EdgeConstraint& c, const ReferenceState& s, double compliance,
                        Pull pull) {
    Linearized<2> result{verticesOf(c), {}, 0, c.geometry * compliance, false};
    const Vec3 r = difference(s, c.a, c.b);
    const double length = r.norm();
    if (length > kShortestLength) {
        const Vec3 n = pullDirection(pull, differenceBefore(s, c.a, c.b), r);
        result.valid = true;
        result.value = length - c.rest_length;
        result.gradient = {n, -n};
    }
    return result;
}

/// C = angle - rest angle, wrapped, then clamped to kMaxBendError.
Linearized<4> linearize(const BendConstraint& c, const ReferenceState& s, double compliance,
                        Pull pull) {
    Linearized<4> result{verticesOf(c), {}, 0, c.geometry * compliance, false};
    const Wings before{differenceBefore(s, c.v1, c.v0), differenceBefore(s, c.v2, c.v0),
                       differenceBefore(s, c.v3, c.v0)};
    const Wings now{difference(s, c.v1, c.v0), difference(s, c.v2, c.v0),
                    difference(s, c.v3, c.v0)};
    const auto angle = now.angle();
    const auto angleBefore = before.angle();
    if (angle.valid) {
        const double limit = shared::kMaxBendError;
        result.valid = true;
        result.value = std::clamp(wrapAngle(angle.angle - c.rest_angle), -limit, limit);
        const bool asBefore =
            pull == Pull::asBefore && angleBefore.valid && before.turnedLittleTo(now);
        result.gradient = asBefore ? angleBefore.gradient : angle.gradient;
    }
    return result;
}

/// C = distance from the vertex to the point on the opposite side - rest length.
Linearized<4> linearize(const shared::IspcConstraint& c, const ReferenceState& s, double compliance,
                        Pull pull) {
    Linearized<4> result{verticesOf(c), {}, 0, c.geometry * compliance, false};
    const double b1 = c.b1;
    const double b2 = c.b2;
    const double b0 = 1 - b1 - b2;
    const auto span = [&](const auto& difference) -> Vec3 {
        return b0 * difference(s, c.vertex, c.t0) + b1 * difference(s, c.vertex, c.t1) +
               b2 * difference(s, c.vertex, c.t2);
    };
    const Vec3 r = span(difference);
    const double length = r.norm();
    if (length > kShortestLength) {
        const Vec3 n = pullDirection(pull, span(differenceBefore), r);
        result.valid = true;
        result.value = length - c.rest_length;
        result.gradient = {n, -b0 * n, -b1 * n, -b2 * n};
    }
    return result;
}

double strainEnergy(const BodyModel& model, const shared::SolverUniforms& uniforms,
                    const ReferenceState& state) {
    const double square = static_cast<double>(uniforms.substep) * uniforms.substep;
    double sum = 0;
    forEachType(model, [&](auto row, const auto& constraints) {
        const bool on = (uniforms.active_parts >> row.kType & 1u) != 0;
        sum +=
            sumOver(model, constraints, on ? square * uniforms.compliance[row.kType] : 0.0, state);
    });
    return sum;
}

}  // namespace kerf
