#include "sim/repair/vertex_parting.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "sim/base/float_rounding.h"
#include "sim/mesh/triangle.h"
#include "sim/repair/soup_editing.h"

namespace kerf::repair {

namespace {

// How far vertices move apart, in edges: a float tells them apart, a person does not.
constexpr double kParting = 1e-3;
constexpr int kMostPartings = 6;

/// Groups of vertices that are one place in floats, each ascending.
std::vector<std::vector<int>> sharedPlaces(const TriangleSoup& soup) {
    const auto placeOf = [&](int v) {
        const Vec3 p = nearestFloats(soup.positions[v]);
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

/// The way into the material at each vertex, as long as its shortest edge.
std::vector<Vec3> waysInward(const TriangleSoup& soup) {
    std::vector<Vec3> normals(soup.positions.size(), Vec3::Zero());
    std::vector<double> edges(soup.positions.size(), 0);
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const Corners at = cornersOf(soup, t);
        for (int i = 0; i < 3; ++i) {
            const int v = soup.triangles[t][i];
            normals[v] += areaNormal(at);
            const double edge = (at[(i + 1) % 3] - at[i]).norm();
            edges[v] = edges[v] == 0 ? edge : std::min(edges[v], edge);
        }
    }
    for (std::size_t v = 0; v < normals.size(); ++v) {
        normals[v] = -edges[v] * normals[v].stableNormalized();
    }
    return normals;
}

}  // namespace

int moveApart(TriangleSoup& soup) {
    int moved = 0;
    double share = kParting;
    for (int round = 0; round < kMostPartings; ++round, share *= 2) {
        const std::vector<std::vector<int>> groups = sharedPlaces(soup);
        if (groups.empty()) {
            break;
        }
        const std::vector<Vec3> inward = waysInward(soup);
        for (const std::vector<int>& group : groups) {
            // Not by the same share, since two may have the same way.
            double own = share;
            for (const int v : group) {
                soup.positions[v] += own * inward[v];
                own += share / 2;
                ++moved;
            }
        }
    }
    return moved;
}

}  // namespace kerf::repair
