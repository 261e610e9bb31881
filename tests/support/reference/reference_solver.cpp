#include "tests/support/reference/reference_solver.h"

#include "sim/body/piece_masses.h"
#include "sim/mesh/triangle.h"
#include "tests/support/reference/reference_constraints.h"

namespace kerf {

namespace {

/// As leastWeight in shaders/sim/constraints/bend.glsl; `lightest`: the largest inverse mass.
double leastWeight(const BendConstraint&, const Linearized<4>& c, double lightest) {
    const double apexes = c.gradient[2].squaredNorm() + c.gradient[3].squaredNorm();
    return shared::kLeastBendShare * lightest * apexes;
}

template <class Constraint, std::size_t N>
double leastWeight(const Constraint&, const Linearized<N>&, double) {
    return 0;
}

/// delta lambda of one rigid constraint, with the mass of each vertex split among its constraints
/// of this type (w~ = valence * w).
template <class Constraint, std::size_t N>
double multiplier(const Constraint& constraint, const Linearized<N>& c,
                  const std::vector<double>& w, const Incidence& incidence) {
    double sum = 0;
    double lightest = 0;
    for (std::size_t k = 0; k < N; ++k) {
        const std::uint32_t v = c.vertices[k];
        const double inverseMass = valence(incidence, v) * w[v];
        lightest = std::max(lightest, inverseMass);
        sum += inverseMass * c.gradient[k].squaredNorm();
    }
    const bool answers = sum > 0 && sum >= leastWeight(constraint, c, lightest);
    return answers ? -c.value / sum : 0.0;
}

/// One Jacobi sweep over constraints of one type: all read the same state, corrections are summed.
template <class Constraint>
void sweep(ReferenceState& state, const std::vector<Constraint>& constraints,
           const Incidence& incidence, const std::vector<double>& w, double share) {
    std::vector<Vec3> correction(state.positions.size(), Vec3::Zero());
    for (const Constraint& constraint : constraints) {
        const auto c = linearize(constraint, state);
        if (!c.valid) {
            continue;
        }
        const double lambda = share * multiplier(constraint, c, w, incidence);
        for (std::size_t k = 0; k < c.vertices.size(); ++k) {
            correction[c.vertices[k]] += w[c.vertices[k]] * lambda * c.gradient[k];
        }
    }
    for (std::size_t v = 0; v < correction.size(); ++v) {
        state.displacements[v] += correction[v];
    }
}

Vec3 at(const ReferenceState& s, std::size_t v) {
    return s.positions[v] + s.displacements[v];
}

/// Mean of the vertices of each piece.
std::vector<Vec3> pieceCenters(const BodyModel& model, const ReferenceState& s) {
    std::vector<Vec3> centers(model.pieces.size(), Vec3::Zero());
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
        if (const int piece = model.pieceOfVertex[v]; piece >= 0) {
            centers[piece] += at(s, v);
        }
    }
    for (std::size_t p = 0; p < centers.size(); ++p) {
        centers[p] /= model.pieces[p].vertexCount;
    }
    return centers;
}

}  // namespace

ReferenceState restState(const BodyModel& model) {
    ReferenceState state;
    for (const Vec3f& p : model.restPositions) {
        state.positions.push_back(p.cast<double>());
    }
    state.displacements.assign(state.positions.size(), Vec3::Zero());
    state.velocities.assign(state.positions.size(), Vec3::Zero());
    return state;
}

ReferenceSolver::ReferenceSolver(const BodyModel& model, const shared::SolverUniforms& uniforms)
    : model_(model), uniforms_(uniforms) {
    for (const double mass : unitMasses(model)) {
        inverseMass_.push_back(mass > 0 ? static_cast<double>(uniforms.inverse_density) / mass
                                        : 0.0);
    }
}

void ReferenceSolver::step(ReferenceState& state) const {
    predict(state);
    for (std::uint32_t i = 0; i < uniforms_.sweeps; ++i) {
        for (std::uint32_t type = 0; type < kConstraintTypes; ++type) {
            solve(type, state);
        }
        pull(state);
        collideFloor(state);
    }
    finish(state);
}

void ReferenceSolver::predict(ReferenceState& state) const {
    const double h = uniforms_.substep;
    const Vec3 gravity(uniforms_.gravity.x, uniforms_.gravity.y, uniforms_.gravity.z);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        if (inverseMass_[v] > 0) {
            state.velocities[v] += h * gravity;
        }
        state.displacements[v] = h * state.velocities[v];
    }
}

void ReferenceSolver::solve(std::uint32_t type, ReferenceState& state) const {
    forEachType(model_, [&](auto row, const auto& constraints) {
        if (row.kType == type && (uniforms_.active_parts >> type & 1u) != 0) {
            sweep(state, constraints, model_.incidences[type], inverseMass_, uniforms_.share[type]);
        }
    });
}

void ReferenceSolver::pull(ReferenceState& state) const {
    const double h = uniforms_.substep;
    const double r = shared::kPullRate * h;
    for (const shared::PullRecord& pull : pulls_) {
        if (inverseMass_[pull.vertex] <= 0) {
            continue;
        }
        Vec3& d = state.displacements[pull.vertex];
        if (pull.leads == shared::kForcePull) {
            d += h * h / uniforms_.sweeps * Vec3(pull.motion_x, pull.motion_y, pull.motion_z);
            continue;
        }
        const Vec3 target(pull.target_x, pull.target_y, pull.target_z);
        const Vec3 slip = d - h * Vec3(pull.motion_x, pull.motion_y, pull.motion_z);
        const Vec3 away = at(state, pull.vertex) - target;
        d -= pull.leads != 0 ? slip : (r * r * away + 2 * r * slip) / (1 + 2 * r + r * r);
    }
}

void ReferenceSolver::collideFloor(ReferenceState& state) const {
    if (!(uniforms_.active_parts & shared::kFloorPart)) {
        return;
    }
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        Vec3& d = state.displacements[v];
        const double lowest =
            std::min(uniforms_.floor_height - state.positions[v].y(),
                     static_cast<double>(uniforms_.lift_speed) * uniforms_.substep);
        const double lift = lowest - d.y();
        if (inverseMass_[v] <= 0 || lift <= 0) {
            continue;
        }
        d.y() += lift;
        const double slide = std::hypot(d.x(), d.z());
        if (slide > 0) {
            const double kept = 1 - std::min(1.0, uniforms_.friction * lift / slide);
            d.x() *= kept;
            d.z() *= kept;
        }
    }
}

void ReferenceSolver::finish(ReferenceState& state) const {
    const double rate = uniforms_.drag_factor / static_cast<double>(uniforms_.substep);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        if (inverseMass_[v] > 0) {
            state.velocities[v] = rate * state.displacements[v];
        }
        state.positions[v] += state.displacements[v];
        state.displacements[v].setZero();
    }
}

std::vector<double> ReferenceSolver::volumes(const ReferenceState& state) const {
    const std::vector<Vec3> centers = pieceCenters(model_, state);
    std::vector<double> volumes(model_.pieces.size(), 0.0);
    for (const auto& triangle : model_.triangles) {
        const int piece = model_.pieceOfVertex[triangle[0]];
        const auto corner = [&](int k) -> Vec3 { return at(state, triangle[k]) - centers[piece]; };
        volumes[piece] += tetrahedronVolume(corner(0), corner(1), corner(2));
    }
    return volumes;
}

}  // namespace kerf
