#include "sim/repair/fault_finder.h"

#include "sim/mesh/triangle_quality.h"
#include "sim/repair/crossings.h"
#include "sim/repair/soup_editing.h"

namespace kerf::repair {

namespace {

bool allUsable(const TriangleSoup& soup) {
    return std::ranges::all_of(soup.triangles,
                               [&](const Triangle& t) { return isUsable(soup, t); });
}

std::vector<int> findDoubles(const TriangleSoup& soup) {
    std::vector<int> order(soup.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int t) { return sortedCorners(soup.triangles[t]); });
    std::vector<int> doubles;
    for (std::size_t i = 1; i < order.size(); ++i) {
        const Triangle& before = soup.triangles[order[i - 1]];
        const Triangle& now = soup.triangles[order[i]];
        if (isUsable(soup, now) && !repeatsCorner(now) &&
            sortedCorners(before) == sortedCorners(now)) {
            doubles.push_back(order[i]);
        }
    }
    std::ranges::sort(doubles);
    return doubles;
}

std::vector<int> findNeedles(const TriangleSoup& soup) {
    std::vector<int> needles;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle& t = soup.triangles[i];
        if (isUsable(soup, t) &&
            isNeedle({soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]})) {
            needles.push_back(static_cast<int>(i));
        }
    }
    return needles;
}

}  // namespace

bool Faults::any() const {
    return std::ranges::any_of(places, [](const FaultLocations& each) { return each.count() > 0; });
}

Faults findFaults(const TriangleSoup& welded, bool crossings) {
    SurfaceFaults surface = findSurfaceFaults(welded);
    Faults faults;
    faults.of(FaultKind::openEdge).edges = std::move(surface.openEdges);
    faults.of(FaultKind::branchingEdge).edges = std::move(surface.nonManifoldEdges);
    faults.of(FaultKind::touchingVertex).vertices = std::move(surface.nonManifoldVertices);
    faults.of(FaultKind::opposedEdge).edges = std::move(surface.misorientedEdges);
    faults.of(FaultKind::flatTriangle).triangles = std::move(surface.degenerateTriangles);
    faults.of(FaultKind::doubleTriangle).triangles = findDoubles(welded);
    faults.of(FaultKind::needle).triangles = findNeedles(welded);
    if (crossings && allUsable(welded)) {
        faults.of(FaultKind::crossingTriangle).triangles = crossingTriangles(welded);
    }
    return faults;
}

}  // namespace kerf::repair
