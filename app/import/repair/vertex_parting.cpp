#include "app/import/repair/vertex_parting.h"

#include "sim/base/math.h"
#include "sim/mesh/triangle.h"
#include "sim/repair/soup_editing.h"

namespace kerf::app {

namespace {

// How far vertices move apart, in edges: a float tells them apart, a person does not.
constexpr double kParting = 1e-3;
// Nor does a corner pass through a shell that is thinner than so much of an edge.
constexpr double kThicknesses = 10;
constexpr int kMostPartings = 6;

/// Groups of vertices that are one place in floats, each ascending.
std::vector<std::vector<int>> sharedPlaces(const TriangleSoup& soup) {
    const Vec3 origin = floatOrigin(soup);
    const auto placeOf = [&](int v) {
        const Vec3 p = nearestFloats(soup.positions[v] - origin);
        return std::array{p.x(), p.y(), p.z()};
    };
    std::vector<int> order(soup.positions.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, placeOf);
    std::vector<std::vector<int>> groups;
    for (std::size_t i = 0; i < order.size();) {
        std::size_t end = i + 1;
        while (end < order.size() && placeOf(order[end]) == placeOf(order[i])) {
            ++end;
        }
        if (end - i > 1) {
            groups.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(i),
                                order.begin() + static_cast<std::ptrdiff_t>(end));
        }
        i = end;
    }
    return groups;
}

/// What the triangles at a vertex tell.
struct Around {
    Vec3 outward = Vec3::Zero();  ///< the normal, of any length
    Vec3 ahead = Vec3::Zero();    ///< the sum of the directions of its edges
    double edge = 0;              ///< the shortest edge, of thin shells some thicknesses [m]
    double shell = 0;             ///< the signed volume of its shell [m^3]
    int part = -1;                ///< the number of its shell

    /// Whether it is a corner of a hollow rather than of a solid.
    bool isHollow() const { return ahead.dot(outward) > 0; }
};

std::vector<Around> aroundVertices(const TriangleSoup& soup) {
    const std::vector<int> parts = repair::partsOf(soup);
    const std::vector<double> volumes = repair::volumesOf(soup, parts);
    const std::vector<double> areas = repair::areasOf(soup, parts);
    std::vector<Around> all(soup.positions.size());
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const Corners at = repair::cornersOf(soup, t);
        const double thick = kThicknesses * std::abs(volumes[parts[t]]) / areas[parts[t]];
        for (int i = 0; i < 3; ++i) {
            Around& around = all[soup.triangles[t][i]];
            const Vec3 way = at[(i + 1) % 3] - at[i];
            around.outward += areaNormal(at);
            around.ahead += way.stableNormalized();
            const double length = std::min(way.norm(), thick);
            around.edge = around.edge == 0 ? length : std::min(around.edge, length);
            around.shell = volumes[parts[t]];
            around.part = parts[t];
        }
    }
    return all;
}

/// Solids that touch are pieces in a file, and stay apart there.
bool areOfSeveralSolids(const std::vector<int>& place, const std::vector<Around>& all) {
    std::set<int> parts;
    return std::ranges::all_of(
        place, [&](int v) { return all[v].shell > 0 && parts.insert(all[v].part).second; });
}

/// 1 for a vertex that moves out of its material, -1 for one that moves into it. Of shells of which
/// one lies in the other the outer one grows and those in it shrink. Else solids shrink, and so do
/// hollows that meet.
int sideOf(int v, const std::vector<int>& place, const std::vector<Around>& all) {
    const auto shellOf = [&](int each) { return all[each].shell; };
    const auto [least, most] = std::ranges::minmax(place, {}, shellOf);
    if (shellOf(least) >= 0 || shellOf(most) <= 0) {
        const auto isHollow = [&](int each) { return all[each].isHollow(); };
        return std::ranges::all_of(place, isHollow) ? 1 : -1;
    }
    const double outermost = shellOf(most) > -shellOf(least) ? shellOf(most) : shellOf(least);
    const int growing = shellOf(v) > 0 ? 1 : -1;
    return shellOf(v) == outermost ? growing : -growing;
}

/// What floats tell apart at a place [m].
double leastMove(const Vec3& place) {
    constexpr double kOfFloats = 5e-7;
    return kOfFloats * place.cwiseAbs().maxCoeff();
}

}  // namespace

int moveApart(TriangleSoup& soup) {
    int moved = 0;
    double share = kParting;
    for (int round = 0; round < kMostPartings; ++round, share *= 2) {
        std::vector<std::vector<int>> places = sharedPlaces(soup);
        if (places.empty()) {
            break;
        }
        const std::vector<Around> all = aroundVertices(soup);
        std::erase_if(places, [&](const auto& place) { return areOfSeveralSolids(place, all); });
        for (const std::vector<int>& place : places) {
            // Not by the same share, since two may have the same way.
            double own = share;
            for (const int v : place) {
                const double length = std::max(own * all[v].edge, leastMove(soup.positions[v]));
                soup.positions[v] +=
                    sideOf(v, place, all) * length * all[v].outward.stableNormalized();
                own += share / 2;
                ++moved;
            }
        }
    }
    return moved;
}

}  // namespace kerf::app
