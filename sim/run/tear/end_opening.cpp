#include "sim/run/tear/end_opening.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

// Openings one edge behind an end at which it advances, of the law's reach: where walls are bonded,
// and where they are free, as linear elasticity has it at a quarter of the toughness; there a reach
// of more edges than kLongestReach counts as so many, as soft bodies blunt the end.
constexpr double kBondedOpening = 0.15;
constexpr double kFreeOpening = 0.4;
constexpr double kLongestReach = 0.6;
constexpr double kLeastOfReach = 0.05;
constexpr double kOneFront = 3;  // edges: an end up to so long advances evenly

/// The reach of the law where walls are free [m].
double freeReach(const CohesiveZone& cohesion, double edge) {
    const double reach = cohesion.law().reach();
    return std::min(reach, std::max(kLongestReach * edge, kLeastOfReach * reach));
}

/// The opening of a point of W+ at which the end of its slit advances, `behind` from it [m].
double neededAt(const CohesiveZone& cohesion, double edge, int plus, double behind) {
    const CohesiveZone::Bond* bond = cohesion.find(plus);
    const double edges = behind / edge;
    return bond != nullptr && !bond->isBroken()
               ? kBondedOpening * bond->reach() * edges * std::sqrt(edges)
               : kFreeOpening * freeReach(cohesion, edge) * std::sqrt(edges);
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
