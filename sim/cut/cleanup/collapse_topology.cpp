#include "sim/cut/cleanup/collapse_topology.h"

#include <algorithm>
#include <map>
#include <utility>

namespace kerf::cut {

namespace {

constexpr int kLeastValence = 3;

std::vector<int> neighbours(const SurfaceMesh& mesh, int v) {
    std::vector<int> result;
    mesh.forEachOutgoing(v, [&](int h) { result.push_back(mesh.target(h)); });
    return result;
}

bool contains(const std::vector<int>& list, int value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

std::optional<CopyPairing> pairCopies(const SurfaceMesh& mesh, const SharedStar& from,
                                      const SharedStar& to) {
    CopyPairing pairing;
    for (const int u : from.copies) {
        std::vector<int> edges;
        mesh.forEachOutgoing(u, [&](int h) {
            if (contains(to.copies, mesh.target(h))) {
                edges.push_back(h);
            }
        });
        if (edges.size() > 1) {
            return std::nullopt;
        }
        if (edges.empty()) {
            pairing.unpaired.push_back(u);
        } else {
            pairing.edges.push_back(edges[0]);
        }
    }
    return pairing.edges.empty() ? std::nullopt : std::optional(std::move(pairing));
}

bool keepsSharedComplex(const SharedStar& from, const SharedStar& to) {
    const SharedEdge& between = *from.edgeTo(to.point);
    return std::all_of(from.edges.begin(), from.edges.end(), [&](const SharedEdge& edge) {
        const SharedEdge* other = edge.neighbour == to.point ? nullptr : to.edgeTo(edge.neighbour);
        return other == nullptr ||
               (between.hasApex(edge.neighbour) && !(edge.isFeature() && other->isFeature()));
    });
}

bool keepsMeshComplex(const SurfaceMesh& mesh, const std::vector<int>& edges) {
    std::vector<std::pair<int, int>> added;
    std::map<int, int> lost;  // triangles by apex
    for (const int h : edges) {
        const int kept = mesh.target(h);
        const int left = mesh.apex(h);
        const int right = mesh.apex(mesh.twin(h));
        if (left == right) {
            return false;
        }
        ++lost[left];
        ++lost[right];
        const std::vector<int> known = neighbours(mesh, kept);
        for (const int x : neighbours(mesh, mesh.origin(h))) {
            if (x == kept || x == left || x == right) {
                continue;
            }
            if (contains(known, x)) {
                return false;
            }
            added.emplace_back(kept, x);
        }
    }
    std::sort(added.begin(), added.end());
    return std::adjacent_find(added.begin(), added.end()) == added.end() &&
           std::all_of(lost.begin(), lost.end(), [&](const std::pair<const int, int>& apex) {
               return mesh.valence(apex.first) - apex.second >= kLeastValence;
           });
}

//        left                  left
//       / |  \                  |  \      the triangles beside a -> b go; their outer
//     a --h-- b      ->         b         neighbours become neighbours of each other
//       \ |  /                  |  /
//        right                 right
std::array<int, 2> collapseHalfEdge(SurfaceMesh& mesh, int h) {
    const int g = mesh.twin(h);
    const int a = mesh.origin(h), b = mesh.target(h);
    const int left = mesh.apex(h), right = mesh.apex(g);
    std::vector<int> spokes;
    mesh.forEachOutgoing(a, [&](int spoke) { spokes.push_back(spoke); });
    const int leftToB = mesh.twin(SurfaceMesh::next(h));
    const int aToLeft = mesh.twin(SurfaceMesh::previous(h));
    const int rightToA = mesh.twin(SurfaceMesh::next(g));
    const int bToRight = mesh.twin(SurfaceMesh::previous(g));
    for (const int spoke : spokes) {
        if (spoke / 3 != h / 3 && spoke / 3 != g / 3) {
            mesh.setCorner(spoke / 3, spoke % 3, b);
        }
    }
    mesh.link(leftToB, aToLeft);
    mesh.link(rightToA, bToRight);
    mesh.setOutgoing(b, aToLeft);
    mesh.setOutgoing(left, leftToB);
    mesh.setOutgoing(right, rightToA);
    return {h / 3, g / 3};
}

}  // namespace kerf::cut
