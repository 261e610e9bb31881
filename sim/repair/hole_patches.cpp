#include "sim/repair/hole_patches.h"

#include <algorithm>
#include <vector>

#include "sim/mesh/hole_filling.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/remesher.h"
#include "sim/repair/soup_editing.h"

namespace kerf::repair {

namespace {

double lengthOf(const TriangleSoup& soup, const Side& side) {
    return (soup.positions[side.high] - soup.positions[side.low]).norm();
}

/// The mean length of the edges around each patch of triangles from `first` on, by triangle.
std::vector<double> edgesAround(const TriangleSoup& soup, int first) {
    UnionFind patches(soup.triangles.size());
    const std::vector<Side> sides = sidesByEdge(soup.triangles);
    forEachEdge(sides, [&](const Side* begin, const Side* end) {
        for (const Side* side = begin; side + 1 < end; ++side) {
            if (side->triangle() >= first && side[1].triangle() >= first) {
                patches.join(side->triangle(), side[1].triangle());
            }
        }
    });
    std::vector<double> sums(soup.triangles.size(), 0);
    std::vector<int> counts(soup.triangles.size(), 0);
    forEachEdge(sides, [&](const Side* begin, const Side* end) {
        const int last = end[-1].triangle();
        if (begin->triangle() < first && last >= first) {
            sums[patches.root(last)] += lengthOf(soup, *begin);
            ++counts[patches.root(last)];
        }
    });
    std::vector<double> edges(soup.triangles.size(), 0);
    for (int t = first; t < static_cast<int>(edges.size()); ++t) {
        const int patch = patches.root(t);
        edges[t] = sums[patch] / std::max(1, counts[patch]);
    }
    return edges;
}

}  // namespace

FilledHoles fillHolesEvenly(TriangleSoup& soup) {
    const std::size_t before = soup.triangles.size();
    FilledHoles filled;
    filled.holes = fillHoles(soup).holes;
    if (filled.holes == 0) {
        return filled;
    }
    Remesher::Order order;
    order.edge = edgesAround(soup, static_cast<int>(before));
    order.free.assign(soup.triangles.size(), 1);
    std::fill_n(order.free.begin(), before, 0);
    order.hardAngle = 360;
    Remesher(soup, order).run();
    filled.triangles = static_cast<int>(soup.triangles.size() - before);
    return filled;
}

}  // namespace kerf::repair
