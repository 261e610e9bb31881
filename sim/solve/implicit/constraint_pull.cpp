#include "sim/solve/implicit/constraint_pull.h"

#include "shaders/shared/implicit_records.h"
#include "shaders/shared/solver_uniforms.h"
#include "sim/base/containers.h"
#include "sim/body/rest_geometry.h"

namespace kerf {

namespace {

constexpr double kShortestLength = 1e-12;  // [m]; a shorter segment has no direction

/// Of the vector `span`, the sum of its vertices by `weights`.
template <std::size_t N>
ConstraintPull springPull(const std::array<std::uint32_t, N>& vertices,
                          const std::array<double, N>& weights, const Vec3& span, double rest,
                          double stiffness) {
    ConstraintPull pull;
    const double length = span.norm();
    if (!(length > kShortestLength)) {
        return pull;
    }
    pull.count = N;
    pull.direction = span / length;
    pull.value = length - rest;
    pull.stiffness = stiffness;
    const double turns = std::max(pull.value, -pull.value - shared::kMostBuckling * rest) / length;
    pull.across = stiffness * std::clamp<double>(turns, 0, shared::kMostAcross);
    for (std::size_t k = 0; k < N; ++k) {
        pull.vertices[k] = vertices[k];
        pull.weights[k] = weights[k];
        pull.gradients[k] = weights[k] * pull.direction;
    }
    return pull;
}

double steepestOf(const std::array<Vec3, 4>& gradients) {
    double most = 0;
    for (const Vec3& gradient : gradients) {
        most = std::max(most, gradient.squaredNorm());
    }
    return most;
}

template <class Places>
Dihedral<double> angleOf(const BendConstraint& bend, const Places& places) {
    const auto at = [&](std::uint32_t v) -> Vec3 { return places[v].template cast<double>(); };
    const Vec3 p = at(bend.v0);
    return dihedral<double>(at(bend.v1) - p, at(bend.v2) - p, at(bend.v3) - p);
}

}  // namespace

ConstraintPull pullOf(const EdgeConstraint& edge, double modulus, std::span<const Vec3> positions) {
    return springPull<2>({edge.a, edge.b}, {1, -1}, positions[edge.a] - positions[edge.b],
                         edge.rest_length, modulus / edge.geometry);
}

ConstraintPull pullOf(const IspcConstraint& ispc, double modulus, std::span<const Vec3> positions) {
    const double b1 = ispc.b1;
    const double b2 = ispc.b2;
    const double b0 = 1 - b1 - b2;
    const Vec3& p = positions[ispc.vertex];
    const Vec3 span = b0 * (p - positions[ispc.t0]) + b1 * (p - positions[ispc.t1]) +
                      b2 * (p - positions[ispc.t2]);
    return springPull<4>(verticesOf(ispc), {1, -b0, -b1, -b2}, span, ispc.rest_length,
                         modulus / ispc.geometry);
}

double steepnessAtRest(const BendConstraint& bend, std::span<const Vec3f> rest) {
    const auto angle = angleOf(bend, rest);
    return angle.valid ? steepestOf(angle.gradient) : 0.0;
}

ConstraintPull pullOf(const BendConstraint& bend, double modulus, std::span<const Vec3> positions,
                      double steepness) {
    ConstraintPull pull;
    const auto angle = angleOf(bend, positions);
    if (!angle.valid || !(steepness > 0)) {
        return pull;
    }
    constexpr double kMost = shared::kMaxBendError;
    const double error = wrapAngle(angle.angle - bend.rest_angle);
    const double steepest = steepestOf(angle.gradient);
    pull.count = 4;
    pull.vertices = verticesOf(bend);
    pull.gradients = angle.gradient;
    pull.value = std::clamp(error, -kMost, kMost);
    pull.stiffness =
        modulus / bend.geometry * std::min(1.0, shared::kMostSteepness * steepness / steepest);
    pull.secant = std::fabs(error) > kMost ? kMost / std::fabs(error) : 1.0;
    return pull;
}

void boundFirmness(ConstraintPull& pull, std::span<const double> masses, double firmest) {
    double moved = 0;
    for (int k = 0; k < pull.count; ++k) {
        const double mass = masses[pull.vertices[k]];
        moved += mass > 0 ? pull.gradients[k].squaredNorm() / mass : 0;
    }
    const double share = std::min(1.0, firmest / std::max(moved * pull.stiffness, 1e-300));
    pull.stiffness *= share;
    pull.across *= share;
}

std::vector<double> bendSteepness(const BodyModel& model) {
    return mapped(model.bends, [&](const BendConstraint& bend) {
        return steepnessAtRest(bend, model.restPositions);
    });
}

std::vector<ConstraintPull> pullsAtRest(const BodyModel& model, const TypeModuli& moduli) {
    std::vector<ConstraintPull> pulls;
    pulls.reserve(model.edges.size() + model.bends.size() + model.ispcs.size());
    // At rest no bend is softer, whatever its steepness is there.
    const std::vector<double> steepest(model.bends.size(), std::numeric_limits<double>::infinity());
    forEachPull(model, moduli, steepest, restPlaces(model),
                [&](const ConstraintPull& pull) { pulls.push_back(pull); });
    return pulls;
}

std::vector<ConstraintPull> boundedPullsAtRest(const BodyModel& model, const TypeModuli& moduli,
                                               std::span<const double> masses, double firmest) {
    std::vector<ConstraintPull> pulls = pullsAtRest(model, moduli);
    for (ConstraintPull& pull : pulls) {
        boundFirmness(pull, masses, firmest);
    }
    return pulls;
}

std::vector<Vec3> restPlaces(const BodyModel& model) {
    return mapped(model.restPositions, [](const Vec3f& p) { return Vec3(p.cast<double>()); });
}

}  // namespace kerf
