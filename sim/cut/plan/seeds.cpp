#include "sim/cut/plan/seeds.h"

#include <algorithm>

#include "sim/mesh/union_find.h"

namespace kerf::cut {

int countSeeds(const SurfaceMesh& mesh, const std::vector<int>& touched) {
    const int count = static_cast<int>(touched.size());
    UnionFind groups(count);
    for (int i = 0; i < count; ++i) {
        for (int e = 0; e < 3; ++e) {
            const int neighbour = mesh.twin(3 * touched[i] + e) / 3;
            const auto at = std::lower_bound(touched.begin(), touched.end(), neighbour);
            if (at != touched.end() && *at == neighbour) {
                groups.join(i, static_cast<int>(at - touched.begin()));
            }
        }
    }
    int seeds = 0;
    for (int i = 0; i < count; ++i) {
        seeds += groups.root(i) == i;
    }
    return seeds;
}

}  // namespace kerf::cut
