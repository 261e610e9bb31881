#include "sim/reference/reference_energy.h"

#include <algorithm>
#include <cmath>

#include "sim/body/dihedral.h"
#include "sim/reference/reference_constraints.h"

namespace kerf {

namespace {

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
