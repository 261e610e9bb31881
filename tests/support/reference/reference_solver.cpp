#include "tests/support/reference/reference_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shaders/shared/unfold_records.h"
#include "sim/body/piece_masses.h"
#include "sim/mesh/triangle.h"
#include "tests/support/reference/reference_constraints.h"
#include "tests/support/reference/reference_unfolding.h"

namespace kerf {

namespace {

/// What C changes by for each metre of the vertex that changes it most.
template <class Constraint, std::size_t N>
double changePerWay(const Constraint&, const Linearized<N>&) {
    return 1;
}

double changePerWay(const BendConstraint&, const Linearized<4>& c) {
    return std::max(c.gradient[2].norm(), c.gradient[3].norm());
}

/// As leastWeight in shaders/sim/constraints/bend.glsl; `lightest`: the largest inverse mass.
double leastWeight(const BendConstraint&, const Linearized<4>& c, double lightest) {
    const double apexes = c.gradient[2].squaredNorm() + c.gradient[3].squaredNorm();
    return c.compliance > 0 ? 0 : shared::kLeastBendShare * lightest * apexes;
}

template <class Constraint, std::size_t N>
double leastWeight(const Constraint&, const Linearized<N>&, double) {
    return 0;
}

/// How constraints are damped at one place.
struct Damping {
    double gamma = 0;  ///< beta / h
    double most = 0;   ///< of C at X that is answered in a substep
    bool trueModulus = false;
    double room = 0;  ///< SolverUniforms::sweep_room
};

/// As in shaders/sim/pull_direction.glsl.
Damping dampingAt(double fold, const shared::SolverUniforms& uniforms, double perWay,
                  std::uint32_t type) {
    const double creep = uniforms.catch_up_speed * uniforms.substep * perWay;
    return {uniforms.damping_ratio * (1 - fold),
            fold > 0 ? creep / fold : std::numeric_limits<double>::infinity(),
            (uniforms.active_parts & shared::kTrueModulusPart) != 0, uniforms.sweep_room[type]};
}

/// As dampingOf in shaders/sim/pull_direction.glsl.
double gammaOf(const Damping& damping, double weight, double compliance) {
    const double room = 2 * compliance / (damping.room * weight) - 1.5;
    return damping.trueModulus ? std::clamp(room, 0.0, damping.gamma) : damping.gamma;
}

/// As dampedWeight there.
double dampedWeight(const Damping& damping, double gamma, double weight, double compliance) {
    return damping.trueModulus ? std::max(compliance, damping.room * (0.75 + 0.5 * gamma) * weight)
                               : (1 + gamma) * weight + compliance;
}

/// delta lambda of one constraint: XPBD with stiffness-proportional damping and
/// the mass of each vertex split among its constraints of this type (w~ = valence * w).
template <class Constraint, std::size_t N>
double multiplier(const Constraint& constraint, const Linearized<N>& c, const ReferenceState& s,
                  const std::vector<double>& w, const Incidence& incidence,
                  const Damping& damping) {
    double sum = 0;
    double rate = 0;
    double lightest = 0;
    for (std::size_t k = 0; k < N; ++k) {
        const std::uint32_t v = c.vertices[k];
        const double inverseMass = valence(incidence, v) * w[v];
        lightest = std::max(lightest, inverseMass);
        sum += inverseMass * c.gradient[k].squaredNorm();
        rate += c.gradient[k].dot(s.displacements[v]);
    }
    const double gamma = gammaOf(damping, sum, c.compliance);
    const double denominator = dampedWeight(damping, gamma, sum, c.compliance);
    const double before = std::clamp(c.value - rate, -damping.most, damping.most);
    const bool answers = denominator > 0 && sum >= leastWeight(constraint, c, lightest);
    return answers ? -(before + (1 + gamma) * rate) / denominator : 0.0;
}

Pull pullOf(const shared::SolverUniforms& uniforms) {
    return (uniforms.active_parts & shared::kPullAsBeforePart) != 0 ? Pull::asBefore : Pull::asNow;
}

/// One Jacobi sweep over constraints of one type: all read the same state, corrections are summed.
template <class Constraint>
void sweep(ReferenceState& state, const BodyModel& model,
           const std::vector<Constraint>& constraints, const Incidence& incidence,
           const std::vector<double>& w, const shared::SolverUniforms& uniforms,
           std::uint32_t type) {
    std::vector<Vec3> correction(state.positions.size(), Vec3::Zero());
    for (const Constraint& constraint : constraints) {
        const double modulus = model.memberOf(verticesOf(constraint)[0]).modulus;
        const auto c =
            linearize(constraint, state, uniforms.compliance[type] / modulus, pullOf(uniforms));
        if (!c.valid) {
            continue;
        }
        double fold = 0;
        for (const std::uint32_t v : c.vertices) {
            fold = std::max(fold, state.fold(v));
        }
        const Damping damping = dampingAt(fold, uniforms, changePerWay(constraint, c), type);
        const double lambda =
            uniforms.share[type] * multiplier(constraint, c, state, w, incidence, damping);
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

/// Volume per piece at X + d, and its gradient by each vertex at X.
struct VolumeTerms {
    std::vector<double> volumes;
    std::vector<Vec3> gradient;
};

VolumeTerms volumeTerms(const BodyModel& model, const ReferenceState& s) {
    const std::vector<Vec3> centers = pieceCenters(model, s);
    VolumeTerms terms{std::vector<double>(model.pieces.size(), 0.0),
                      std::vector<Vec3>(s.positions.size(), Vec3::Zero())};
    for (const auto& triangle : model.triangles) {
        const int piece = model.pieceOfVertex[triangle[0]];
        const Vec3 a = at(s, triangle[0]) - centers[piece];
        const Vec3 b = at(s, triangle[1]) - centers[piece];
        const Vec3 c = at(s, triangle[2]) - centers[piece];
        terms.volumes[piece] += tetrahedronVolume(a, b, c);
        const Vec3 u = s.positions[triangle[0]] - centers[piece];
        const Vec3 v = s.positions[triangle[1]] - centers[piece];
        const Vec3 w = s.positions[triangle[2]] - centers[piece];
        terms.gradient[triangle[0]] += v.cross(w) / 6;
        terms.gradient[triangle[1]] += w.cross(u) / 6;
        terms.gradient[triangle[2]] += u.cross(v) / 6;
    }
    return terms;
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
    : model_(model), uniforms_(uniforms), volumeOffset_(model.pieces.size(), 0.0) {
    for (const double mass : unitMasses(model)) {
        inverseMass_.push_back(mass > 0 ? static_cast<double>(uniforms.inverse_density) / mass
                                        : 0.0);
    }
}

void ReferenceSolver::step(ReferenceState& state) const {
    for (std::uint32_t i = 0; i < uniforms_.substeps; ++i) {
        substep(state);
    }
}

void ReferenceSolver::substep(ReferenceState& state) const {
    unfold(state);
    predict(state);
    for (std::uint32_t i = 0; i < uniforms_.sweeps; ++i) {
        for (std::uint32_t type = 0; type < kConstraintTypes; ++type) {
            solve(type, state);
        }
        solveVolume(state);
        pull(state);
        collideFloor(state);
    }
    finishSubstep(state);
}

void ReferenceSolver::unfold(ReferenceState& state) const {
    if (uniforms_.active_parts & shared::kUnfoldPart) {
        unfoldAsReference(model_, inverseMass_, uniforms_, state);
    }
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
            sweep(state, model_, constraints, model_.incidences[type], inverseMass_, uniforms_,
                  type);
        }
    });
}

void ReferenceSolver::solveVolume(ReferenceState& state) const {
    if (!(uniforms_.active_parts & shared::kVolumePart)) {
        return;
    }
    const VolumeTerms terms = volumeTerms(model_, state);
    std::vector<double> denominator(model_.pieces.size(), 0.0);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        if (const int piece = model_.pieceOfVertex[v]; piece >= 0) {
            denominator[piece] += inverseMass_[v] * terms.gradient[v].squaredNorm();
        }
    }
    std::vector<double> lambda(model_.pieces.size(), 0.0);
    for (std::size_t p = 0; p < lambda.size(); ++p) {
        const PieceModel& piece = model_.pieces[p];
        if (piece.holdsVolume && denominator[p] > 0) {
            lambda[p] = -(terms.volumes[p] - piece.restVolume - volumeOffset_[p]) / denominator[p];
        }
    }
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        if (const int piece = model_.pieceOfVertex[v]; piece >= 0) {
            state.displacements[v] += inverseMass_[v] * lambda[piece] * terms.gradient[v];
        }
    }
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
            const double friction = uniforms_.friction * (1 - state.fold(v));
            const double kept = 1 - std::min(1.0, friction * lift / slide);
            d.x() *= kept;
            d.z() *= kept;
        }
    }
}

void ReferenceSolver::finishSubstep(ReferenceState& state) const {
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
    return volumeTerms(model_, state).volumes;
}

}  // namespace kerf
