#include "tests/support/reference/reference_unfolding.h"

#include <Eigen/LU>

#include "shaders/shared/unfold_records.h"
#include "sim/body/rest_geometry.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

using Matrix = Eigen::Matrix3d;

double turnedOver(const BendConstraint& bend, const std::vector<Vec3>& at) {
    const Vec3& from = at[bend.v0];
    const auto now = dihedral<double>(at[bend.v1] - from, at[bend.v2] - from, at[bend.v3] - from);
    if (!now.valid) {
        return 0;
    }
    const double cosine = std::cos(now.angle - static_cast<double>(bend.rest_angle));
    return std::clamp((shared::kFoldBegins - cosine) / (shared::kFoldBegins - shared::kFoldEnds),
                      0.0, 1.0);
}

/// Of the more squashed one of both triangles.
double squashed(const BendConstraint& bend, const std::vector<Vec3>& at,
                const std::vector<Vec3f>& restPositions) {
    const auto rest = [&](std::uint32_t v) -> Vec3 { return restPositions[v].cast<double>(); };
    double least = 1;
    for (const std::uint32_t apex : {bend.v2, bend.v3}) {
        least = std::min(least, triangleArea(at[bend.v0], at[bend.v1], at[apex]) /
                                    triangleArea(rest(bend.v0), rest(bend.v1), rest(apex)));
    }
    return std::clamp(
        (shared::kSquashBegins - least) / (shared::kSquashBegins - shared::kSquashEnds), 0.0, 1.0);
}

std::vector<double> foldsOf(const BodyModel& model, const std::vector<Vec3>& at,
                            const std::vector<double>& inverseMass) {
    std::vector<double> folds(at.size(), 0.0);
    for (const BendConstraint& bend : model.bends) {
        if (std::ranges::any_of(verticesOf(bend),
                                [&](std::uint32_t v) { return inverseMass[v] == 0; })) {
            continue;
        }
        const double fold = std::max(turnedOver(bend, at), squashed(bend, at, model.restPositions));
        for (const std::uint32_t v : verticesOf(bend)) {
            folds[v] = std::max(folds[v], fold);
        }
    }
    return folds;
}

/// The vertex itself and its neighbours.
std::vector<std::uint32_t> membersAt(const BodyModel& model, std::size_t v) {
    std::vector<std::uint32_t> members{static_cast<std::uint32_t>(v)};
    const IncidenceRange& range = model.neighbours.ranges[v];
    for (std::uint32_t k = range.first; k < range.end; ++k) {
        members.push_back(model.neighbours.entries[k] & ~shared::kAfterGap);
    }
    return members;
}

struct Goal {
    Matrix rotation = Matrix::Identity();
    Vec3 center = Vec3::Zero();
    Vec3 restCenter = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Vec3 spin = Vec3::Zero();
    double share = 1;  ///< of the way there that the spring knows

    Vec3 wayOf(const Vec3& x, const Vec3& rest) const {
        return center + rotation * (rest - restCenter) - x;
    }
};

/// Of the spring in this substep.
double dampingOf(const shared::SolverUniforms& uniforms) {
    const bool firm = (uniforms.active_parts & shared::kUnfoldFirmlyPart) != 0;
    return firm ? shared::kFirmUnfoldDamping : shared::kUnfoldDamping;
}

/// `reach`: how far the spring knows [m]. `masses`: what each vertex lends to a goal, over the fold
/// of it.
Goal goalOf(const BodyModel& model, const std::vector<std::uint32_t>& members,
            const std::vector<double>& masses, const ReferenceState& state, double reach) {
    Goal goal;
    double mass = 0;
    for (const std::uint32_t v : members) {
        mass += masses[v];
        goal.center += masses[v] * state.positions[v];
        goal.restCenter += masses[v] * model.restPositions[v].cast<double>();
        goal.velocity += masses[v] * state.velocities[v];
    }
    goal.center /= mass;
    goal.restCenter /= mass;
    goal.velocity /= mass;
    Matrix covariance = Matrix::Zero();
    Matrix inertia = Matrix::Zero();
    Vec3 angularMomentum = Vec3::Zero();
    for (const std::uint32_t v : members) {
        const Vec3 x = state.positions[v] - goal.center;
        const Vec3 rest = model.restPositions[v].cast<double>() - goal.restCenter;
        covariance += masses[v] * x * rest.transpose();
        inertia += masses[v] * (x.squaredNorm() * Matrix::Identity() - x * x.transpose());
        angularMomentum += masses[v] * x.cross(state.velocities[v] - goal.velocity);
    }
    goal.rotation = bestRotation(covariance);
    goal.spin = inertia.inverse() * angularMomentum;
    double longest = reach;
    for (const std::uint32_t v : members) {
        const Vec3 rest = model.restPositions[v].cast<double>();
        longest = std::max(longest, goal.wayOf(state.positions[v], rest).norm());
    }
    goal.share = reach / longest;
    return goal;
}

/// `springShare`, `dampingShare`: how much of the spring, and of what damps it.
Vec3 pullOf(const Goal& goal, const Vec3& x, const Vec3& rest, const Vec3& velocity,
            const shared::SolverUniforms& uniforms, double springShare, double dampingShare) {
    const Vec3 way = goal.share * goal.wayOf(x, rest);
    const Vec3 slip = velocity - goal.velocity - goal.spin.cross(x - goal.center);
    const double turn = shared::kUnfoldRate * uniforms.substep;
    const double denominator = 1 + dampingOf(uniforms) * turn + turn * turn;
    return springShare * shared::kUnfoldRate * turn * way / denominator +
           dampingShare * (1 / denominator - 1) * slip;
}

}  // namespace

void unfoldAsReference(const BodyModel& model, const std::vector<double>& inverseMass,
                       const shared::SolverUniforms& uniforms, ReferenceState& state) {
    const std::size_t count = state.positions.size();
    state.folds = foldsOf(model, state.positions, inverseMass);
    const std::vector<double>& folds = state.folds;
    std::vector<double> sums(count, 0.0);
    std::vector<double> masses(count, 0.0);
    for (std::size_t v = 0; v < count; ++v) {
        for (const std::uint32_t j : membersAt(model, v)) {
            sums[v] += folds[j];
        }
        masses[v] = sums[v] > 0 && inverseMass[v] > 0 ? 1 / (inverseMass[v] * sums[v]) : 0.0;
    }
    const double reach = uniforms.catch_up_speed * dampingOf(uniforms) / shared::kUnfoldRate;
    std::vector<Vec3> changes(count, Vec3::Zero());
    for (std::size_t v = 0; v < count; ++v) {
        const std::vector<std::uint32_t> members = membersAt(model, v);
        const bool free =
            std::ranges::all_of(members, [&](std::uint32_t j) { return inverseMass[j] > 0; });
        if (folds[v] <= 0 || !free) {
            continue;
        }
        const Goal goal = goalOf(model, members, masses, state, reach);
        const double square = folds[v] * folds[v];
        for (const std::uint32_t j : members) {
            if (inverseMass[j] > 0) {
                changes[j] +=
                    pullOf(goal, state.positions[j], model.restPositions[j].cast<double>(),
                           state.velocities[j], uniforms, square, folds[v]) /
                    sums[j];
            }
        }
    }
    for (std::size_t v = 0; v < count; ++v) {
        state.velocities[v] += changes[v];
    }
}

}  // namespace kerf
