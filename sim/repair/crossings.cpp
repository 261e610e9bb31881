#include "sim/repair/crossings.h"

#include <algorithm>
#include <numeric>

#include "sim/base/sort_unique.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/surface_contact.h"

namespace kerf::repair {

namespace {

// Beyond so many pairs a model is called crossing through and through.
constexpr std::size_t kMostCounted = 1'000'000;

bool haveEdgeInCommon(const Triangle& a, const Triangle& b) {
    return std::ranges::count_if(a, [&](int v) { return std::ranges::find(b, v) != b.end(); }) >= 2;
}

}  // namespace

std::vector<std::pair<int, int>> findCrossings(const TriangleSoup& welded, std::size_t most,
                                               const std::vector<int>* parts) {
    std::vector<int> all(welded.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    const BoxTree::BoundsOf bounds = [&](int t) { return boundsOf(welded, t); };
    BoxTree tree(all, bounds);
    const SurfaceContact contact(welded);
    const auto cross = [&](int a, int b) {
        return (parts == nullptr || (*parts)[a] != (*parts)[b]) &&
               !haveEdgeInCommon(welded.triangles[a], welded.triangles[b]) && contact.crosses(a, b);
    };
    std::vector<std::pair<int, int>> pairs;
    for (const int t : all) {
        const Bounds own = boundsOf(welded, t);
        const auto overlaps = [&](const Bounds& box) { return box.overlaps(own); };
        tree.find(bounds, overlaps, [&](int other) {
            if (other > t && own.overlaps(boundsOf(welded, other)) && cross(t, other)) {
                pairs.emplace_back(t, other);
            }
        });
        if (pairs.size() >= most) {
            break;
        }
    }
    std::ranges::sort(pairs);
    pairs.resize(std::min(pairs.size(), most));
    return pairs;
}

std::vector<int> crossingTriangles(const TriangleSoup& welded) {
    std::vector<int> crossing;
    for (const auto& [a, b] : findCrossings(welded, kMostCounted)) {
        crossing.push_back(a);
        crossing.push_back(b);
    }
    sortUnique(crossing);
    return crossing;
}

}  // namespace kerf::repair
