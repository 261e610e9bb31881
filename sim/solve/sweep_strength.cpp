#include "sim/solve/sweep_strength.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/body/piece_masses.h"
#include "sim/body/solver_uniforms.h"
#include "sim/cut/wall_edge.h"
#include "sim/solve/implicit/step_choice.h"

namespace kerf {

namespace {

using shared::uint;

constexpr int kBinsPerOctave = 4;
constexpr double kEnoughOfTrue = 0.9;
constexpr double kEnoughOfPlain = 0.7;
// What the parts of error() count.
constexpr double kOfStiffness = 0.4;
constexpr double kOfBends = 12;
constexpr double kBendsOverRest = 15;  // what bends resist where a sweep carries all, over the rest
constexpr double kOfWaves = 1.5;
constexpr double kMostOfEdge = 0.1;    // that something fast moves by in a substep
constexpr int kSpeedSteps = 5;         // in which iterations rise with the speed
constexpr double kSlitAngle = 3.13;    // of the edge where two walls meet, which coincide [rad]
constexpr std::size_t kSample = 4096;  // of each type, that stand for all

int mostIterations() {
    return static_cast<int>(findParam("iterations")->high);
}

std::array<double, 2> pullsOf(const EdgeConstraint&, const BodyModel&) {
    return {1, -1};
}
std::array<float, 4> pullsOf(const IspcConstraint& ispc, const BodyModel&) {
    return weightsOf(ispc);
}
/// Of a flat pair of triangles [1/m].
std::array<double, 4> pullsOf(const BendConstraint& bend, const BodyModel& model) {
    const auto at = [&](uint v) -> Vec3 { return model.restPositions[v].cast<double>(); };
    const Vec3 edge = at(bend.v1) - at(bend.v0);
    std::array<double, 4> pulls{};
    for (const int side : {2, 3}) {
        const Vec3 apex = at(side == 2 ? bend.v2 : bend.v3) - at(bend.v0);
        const double height = apex.cross(edge).norm() / edge.norm();
        const double along = apex.dot(edge) / edge.squaredNorm();
        pulls[0] -= (1 - along) / height;
        pulls[1] -= along / height;
        pulls[side] = 1 / height;
    }
    return pulls;
}

/// By how much a uniform stretch of 1, or curvature of 1/m, strains it [m].
double strainedBy(const auto& constraint, const auto&) {
    return constraint.rest_length;
}
double strainedBy(const BendConstraint&, const std::array<double, 4>& pulls) {
    return 1 / pulls[2] + 1 / pulls[3];
}

/// Calls f with all of a list, or with kSample of it, spread by the golden ratio, without a period.
template <class Constraint, class F>
void forSampleOf(const std::vector<Constraint>& list, const F& f) {
    const bool all = list.size() <= kSample;
    for (std::size_t i = 0; i < std::min(list.size(), kSample); ++i) {
        const std::uint64_t place = static_cast<std::uint32_t>(2654435769u * i);
        f(list[all ? i : place * list.size() >> 32]);
    }
}

/// The sum of n |grad C|^2 over unit mass of the vertices of a constraint.
double movedBy(const auto& vertices, const auto& pulls, const Incidence& incidence,
               const BodyModel& model) {
    double sum = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const double pull = pulls[k];
        sum += valence(incidence, vertices[k]) * pull * pull / unitMass(model, vertices[k]);
    }
    return sum;
}

/// Whether constraints made for either are the same but for a factor on the modulus of all.
bool makeSameConstraints(const Params& a, const Params& b) {
    const bool oneMaterial =
        a.models.empty() && b.models.empty() && a.skinThickness == 0 && b.skinThickness == 0;
    return ispcRays(a) == ispcRays(b) && (oneMaterial || a == b);
}

/// What the strengths of a type are multiplied by to be r, and with a true modulus 4 r / 3 s
/// [1/m^2].
double factorOf(uint type, const Params& params) {
    const double h = params.timeStep / numberOfIterations(params);
    const double r = params.density / (params.youngsModulus * modulusFactor(type, params) * h * h);
    return hasTrueModulus(params) ? r / (0.75 * sweepRoom(type)) : r;
}

/// Bends do most of what they do long before they are as stiff as they should be.
double effectOfBend(double carried) {
    return (1 + kBendsOverRest) * carried / (1 + kBendsOverRest * carried);
}

/// Whether a type has a stiffness that a sweep can fall short of, and is looked at.
bool isAsked(uint type, const Params& params) {
    const double factor = modulusFactor(type, params);
    return factor > 0 && std::isfinite(factor) &&
           (type == shared::kStretch || hasTrueModulus(params));
}

}  // namespace

template <class Constraint>
SweepStrength::Constraints SweepStrength::count(const std::vector<Constraint>& list,
                                                const Incidence& incidence,
                                                const BodyModel& model) {
    Constraints counted;
    forSampleOf(list, [&](const Constraint& constraint) {
        const auto vertices = verticesOf(constraint);
        const auto pulls = pullsOf(constraint, model);
        const double compliance = constraint.geometry / model.memberOf(vertices[0]).modulus;
        const double strength = compliance / movedBy(vertices, pulls, incidence, model);
        const double strain = strainedBy(constraint, pulls);
        const double energy = strain * strain / compliance;
        if (strength > 0 && std::isfinite(strength) && std::isfinite(energy)) {
            Alike& alike = counted[std::lround(kBinsPerOctave * std::log2(strength))];
            alike.energy += energy;
            alike.strength += energy * strength;
        }
    });
    const double standsFor = std::max(1.0, double(list.size()) / double(kSample));
    for (auto& [bin, alike] : counted) {
        alike.strength /= alike.energy;
        alike.energy *= standsFor;
    }
    return counted;
}

void SweepStrength::follow(const BodyModel& model, const Params& params) {
    const std::size_t constraints = model.edges.size() + model.ispcs.size() + model.bends.size();
    if (!countedFor_ || !makeSameConstraints(*countedFor_, params) || diagonal_ != model.diagonal) {
        countedFor_ = params;
        diagonal_ = model.diagonal;
        measure(model);
    } else if (params.iterations != kAutoIterations || constraints_ == constraints) {
        return;
    }
    constraints_ = constraints;
    edges_ = count(model.edges, model.incidences[shared::kStretch], model);
    ispcs_ = count(model.ispcs, model.incidences[shared::kIspc], model);
    bends_ = count(model.bends, model.incidences[shared::kBend], model);
    hasSlit_ = std::ranges::any_of(model.bends, [](const BendConstraint& bend) {
        return std::abs(bend.rest_angle) > kSlitAngle;
    });
}

/// What error() and iterationsFor() know of the body's size.
void SweepStrength::measure(const BodyModel& model) {
    const std::vector<Bounds> boxes = memberBoxes(model);
    wavesPerSpeed_ = 0;
    thickness_ = 0;
    for (std::size_t m = 0; m < boxes.size(); ++m) {
        const BodyMember& member = model.members[m];
        const double length = (boxes[m].high - boxes[m].low).maxCoeff();
        if (length > 0) {
            const double speed = std::sqrt(member.modulus / member.density);
            wavesPerSpeed_ = std::max(wavesPerSpeed_, speed / length);
            thickness_ = std::max(thickness_, member.thickness / length);
        }
    }
    edgeLength_ = wallEdgeFor(model.edgeLength, model.diagonal);
}

SweepStrength::Sums SweepStrength::sumsOf(uint type, const Constraints& constraints,
                                          const Params& params) {
    Sums sums;
    if (!isAsked(type, params)) {
        return sums;
    }
    const double weight = modulusFactor(type, params);
    const double factor = factorOf(type, params);
    for (const auto& [bin, alike] : constraints) {
        const double r = factor * alike.strength;
        const double carried = hasTrueModulus(params) ? std::min(1.0, r) : r / (1 + r);
        const double share = type == shared::kBend ? effectOfBend(carried) : carried;
        sums.all += weight * alike.energy;
        sums.carried += weight * alike.energy * share;
    }
    return sums;
}

double SweepStrength::carried(const Params& params) const {
    const Sums edges = sumsOf(shared::kStretch, edges_, params);
    const Sums ispcs = sumsOf(shared::kIspc, ispcs_, params);
    const double all = edges.all + ispcs.all;
    return all > 0 ? (edges.carried + ispcs.carried) / all : 1;
}

bool SweepStrength::isTooLittle(const Params& params) const {
    if (params.solver != SolverMode::smallSteps) {
        return false;
    }
    if (params.iterations == kAutoIterations) {
        return leastError(params) > params.iterationError;
    }
    return carried(params) < (hasTrueModulus(params) ? kEnoughOfTrue : kEnoughOfPlain);
}

double SweepStrength::error(const Params& params) const {
    const Sums bends = sumsOf(shared::kBend, bends_, params);
    const double ofBends = bends.all > 0 ? 1 - bends.carried / bends.all : 0;
    const double substep = params.timeStep / numberOfIterations(params);
    const double waves = wavesPerSpeed_ * std::sqrt(params.youngsModulus / params.density);
    return kOfStiffness * (1 - carried(params)) + kOfBends * thickness_ * thickness_ * ofBends +
           kOfWaves * waves * substep;
}

double SweepStrength::leastError(const Params& params) const {
    Params most = params;
    most.iterations = mostIterations();
    return error(most);
}

int SweepStrength::iterationsFor(const Params& params, double speed) const {
    if (params.solver != SolverMode::smallSteps) {
        return numberOfIterations(params);
    }
    const int most = mostIterations();
    Params tried = params;
    int enough = hasSlit_ ? kUsualSweeps : 1;
    for (int upTo = most; enough < upTo;) {
        tried.iterations = (enough + upTo) / 2;
        const bool tooFew = error(tried) > params.iterationError;
        (tooFew ? enough : upTo) = tried.iterations + (tooFew ? 1 : 0);
    }
    const double edges = edgeLength_ > 0 ? speed * params.timeStep / edgeLength_ : 0;
    const double sound = std::sqrt(params.youngsModulus / params.density);
    const double deep = kUsualSweeps * std::min(1.0, speed / sound);
    const double fast = kSpeedSteps * std::ceil(std::max(edges / kMostOfEdge, deep) / kSpeedSteps);
    return std::max(enough, static_cast<int>(std::min(fast, double(most))));
}

std::optional<int> SweepStrength::enoughIterations(const Params& params) const {
    const int most = mostIterations();
    Params tried = params;
    for (tried.iterations = 1; tried.iterations <= most; ++tried.iterations) {
        if (!isTooLittle(tried)) {
            return tried.iterations;
        }
    }
    return std::nullopt;
}

}  // namespace kerf
