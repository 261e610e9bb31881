#include "sim/cut/cut_change.h"

#include <algorithm>

namespace kerf {

std::vector<int> changedTriangles(const CutDelta& delta) {
    std::vector<int> all;
    for (const auto* list :
         {&delta.removedTriangles, &delta.addedTriangles, &delta.relabelledTriangles}) {
        all.insert(all.end(), list->begin(), list->end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace kerf
