#include "sim/cut/cut_change.h"

#include "sim/base/containers.h"

namespace kerf {

std::vector<int> changedTriangles(const CutDelta& delta) {
    std::vector<int> old = delta.removedTriangles;
    old.insert(old.end(), delta.changedTriangles.begin(), delta.changedTriangles.end());
    sortUnique(old);
    std::vector<int> added = delta.addedTriangles;  // in order already, and many
    sortUnique(added);
    std::vector<int> all;
    all.reserve(old.size() + added.size());
    std::ranges::set_union(old, added, std::back_inserter(all));
    return all;
}

std::vector<std::uint32_t> rewrittenVertices(const SurfaceMesh& mesh, const CutDelta& delta) {
    std::vector<std::uint32_t> all;
    for (const auto* list : {&delta.movedVertices, &delta.deadVertices}) {
        all.insert(all.end(), list->begin(), list->end());
    }
    for (int v = delta.firstNewVertex; v < mesh.vertexCount(); ++v) {
        all.push_back(static_cast<std::uint32_t>(v));
    }
    sortUnique(all);
    return all;
}

void noteRemoved(const std::vector<int>& triangles, const std::vector<int>& vertices,
                 CutDelta& delta) {
    const std::set<int> added(delta.addedTriangles.begin(), delta.addedTriangles.end());
    std::ranges::copy_if(triangles, std::back_inserter(delta.removedTriangles),
                         [&](int t) { return !added.contains(t); });
    std::ranges::copy_if(vertices, std::back_inserter(delta.deadVertices),
                         [&](int v) { return v < delta.firstNewVertex; });
    const auto isGone = [](const std::vector<int>& gone) {
        return [&gone](int i) { return std::ranges::binary_search(gone, i); };
    };
    std::erase_if(delta.addedTriangles, isGone(triangles));
    std::erase_if(delta.changedTriangles, isGone(triangles));
    std::erase_if(delta.movedVertices, isGone(vertices));
}

}  // namespace kerf
