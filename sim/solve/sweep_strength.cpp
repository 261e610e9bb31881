#include "sim/solve/sweep_strength.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/body/piece_masses.h"
#include "sim/body/solver_uniforms.h"

namespace kerf {

namespace {

using shared::uint;

constexpr int kBinsPerOctave = 4;
constexpr double kEnoughOfTrue = 0.9;
constexpr double kEnoughOfPlain = 0.7;

std::array<float, 2> pullsOf(const EdgeConstraint&) {
    return {1.0f, -1.0f};
}
std::array<float, 4> pullsOf(const IspcConstraint& ispc) {
    return weightsOf(ispc);
}

/// The sum of n |grad C|^2 over unit mass of the vertices of a constraint [1/m^3].
template <class Constraint>
double movedBy(const Constraint& constraint, const Incidence& incidence,
               const std::vector<double>& masses) {
    const auto vertices = verticesOf(constraint);
    const auto pulls = pullsOf(constraint);
    double sum = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const double pull = pulls[k];
        sum += valence(incidence, vertices[k]) * pull * pull / masses[vertices[k]];
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
    const double h = params.timeStep / params.iterations;
    const double r = params.density / (params.youngsModulus * modulusFactor(type, params) * h * h);
    return hasTrueModulus(params) ? r / (0.75 * sweepRoom(type)) : r;
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
                                                const Incidence& incidence, const BodyModel& model,
                                                const std::vector<double>& masses) {
    Constraints counted;
    for (const Constraint& constraint : list) {
        const double compliance =
            constraint.geometry / model.memberOf(verticesOf(constraint)[0]).modulus;
        const double strength = compliance / movedBy(constraint, incidence, masses);
        const double length = constraint.rest_length;
        const double volume = length * length / compliance;
        if (strength > 0 && std::isfinite(strength) && std::isfinite(volume)) {
            Alike& alike = counted[std::lround(kBinsPerOctave * std::log2(strength))];
            alike.volume += volume;
            alike.strength += volume * strength;
        }
    }
    for (auto& [bin, alike] : counted) {
        alike.strength /= alike.volume;
    }
    return counted;
}

void SweepStrength::follow(const BodyModel& model, const Params& params) {
    if (countedFor_ && makeSameConstraints(*countedFor_, params) && diagonal_ == model.diagonal) {
        return;
    }
    countedFor_ = params;
    diagonal_ = model.diagonal;
    const std::vector<double> masses = unitMasses(model);
    edges_ = count(model.edges, model.incidences[shared::kStretch], model, masses);
    ispcs_ = count(model.ispcs, model.incidences[shared::kIspc], model, masses);
}

double SweepStrength::carried(const Params& params) const {
    double all = 0;
    double carried = 0;
    for (const auto& [type, constraints] :
         {std::pair(shared::kStretch, &edges_), std::pair(shared::kIspc, &ispcs_)}) {
        if (!isAsked(type, params)) {
            continue;
        }
        const double weight = modulusFactor(type, params);
        const double factor = factorOf(type, params);
        for (const auto& [bin, alike] : *constraints) {
            const double r = factor * alike.strength;
            const double share = hasTrueModulus(params) ? std::min(1.0, r) : r / (1 + r);
            all += weight * alike.volume;
            carried += weight * alike.volume * share;
        }
    }
    return all > 0 ? carried / all : 1;
}

bool SweepStrength::isTooLittle(const Params& params) const {
    return params.solver == SolverMode::smallSteps &&
           carried(params) < (hasTrueModulus(params) ? kEnoughOfTrue : kEnoughOfPlain);
}

std::optional<int> SweepStrength::enoughIterations(const Params& params) const {
    const int most = static_cast<int>(findParam("iterations")->high);
    Params tried = params;
    for (tried.iterations = 1; tried.iterations <= most; ++tried.iterations) {
        if (!isTooLittle(tried)) {
            return tried.iterations;
        }
    }
    return std::nullopt;
}

}  // namespace kerf
