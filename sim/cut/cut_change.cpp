#include "sim/cut/cut_change.h"

#include <algorithm>

#include "sim/sort_unique.h"

namespace kerf {

std::vector<int> changedTriangles(const CutDelta& delta) {
    std::vector<int> all;
    for (const auto* list :
         {&delta.removedTriangles, &delta.addedTriangles, &delta.changedTriangles}) {
        all.insert(all.end(), list->begin(), list->end());
    }
    sortUnique(all);
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

}  // namespace kerf
