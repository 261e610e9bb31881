#include "sim/run/tear/end_opening.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

// Opening one edge behind an end at which it advances where walls are free, of the law's reach were
// the cohesive zone as short as can be: linear elasticity at a quarter of the toughness. There a
// reach of more edges than kLongestReach counts as so many, as soft bodies blunt the end.
constexpr double kFreeOpening = 0.4;
constexpr double kLongestReach = 0.6;
constexpr double kLeastOfReach = 0.05;
constexpr double kOneFront = 3;  // edges: an end up to so long advances evenly

/// The reach of the law where walls are free [m].
double freeReach(const TearLaw& law, double edge) {
    const double reach = law.reach() * std::sqrt(kEdgesInZone / law.zone);
    return std::min(reach, std::max(kLongestReach * edge, kLeastOfReach * reach));
}

/// The opening of a point of W+ at which the end of its slit advances, `behind` from it [m]: where
/// walls are bonded, the law's reach at the other end of the zone.
double neededAt(const CohesiveZone& cohesion, double edge, int plus, double behind) {
    const CohesiveZone::Bond* bond = cohesion.find(plus);
    return bond != nullptr && !bond->isBroken()
               ? bond->reach() * std::pow(behind / (cohesion.law().zone * edge), 1.5)
               : kFreeOpening * freeReach(cohesion.law(), edge) * std::sqrt(behind / edge);
}

}  // namespace

EndOpening openingOf(const SurfaceMesh& mesh, const CohesiveZone& cohesion, double edge,
                     const SlitEnd& end) {
    EndOpening opening;
    double ofFirst = 1e-300;
    double ofLast = 1e-300;
    const bool even = restLength(mesh, end) < kOneFront * edge;
    for (const auto& [v, place] : pointsBehind(mesh, end, kEdgesInZone * edge)) {
        const int facing = facingVertex(mesh, v, end.label + 1);
        if (facing < 0) {
            continue;
        }
        const Vec3 way = mesh.position(v) - mesh.position(facing);
        const double share = even ? 0.5 : place.share;
        const double open =
            way.norm() / std::max(neededAt(cohesion, edge, v, place.distance), 1e-12);
        opening.atFirst += (1 - share) * place.distance * open;
        opening.atLast += share * place.distance * open;
        ofFirst += (1 - share) * place.distance;
        ofLast += share * place.distance;
        opening.way += way;
    }
    opening.atFirst /= ofFirst;
    opening.atLast /= ofLast;
    return opening;
}

}  // namespace kerf
