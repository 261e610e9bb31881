#include "sim/repair/shell_nesting.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/mesh/winding.h"
#include "sim/repair/crossings.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/surface_contact.h"

namespace kerf::repair {

namespace {

constexpr int kLeastSamples = 5;
constexpr double kMostTests = 3e8;  // of a point with a triangle: about a second

int addShell(SoupShells& shells, int firstTriangle) {
    shells.volumes.push_back(0);
    shells.areas.push_back(0);
    shells.bounds.emplace_back();
    shells.firsts.push_back(firstTriangle);
    shells.counts.push_back(0);
    return shells.size() - 1;
}

/// So many triangles of the shell, spread over it, or all.
std::vector<int> samplesOf(const SoupShells& shells, int shell, int count) {
    std::vector<int> samples;
    const int step = std::max(1, shells.counts[shell] / count);
    int seen = 0;
    for (int t = shells.firsts[shell]; seen < shells.counts[shell]; ++t) {
        if (shells.ofTriangle[t] == shell && seen++ % step == 0) {
            samples.push_back(t);
        }
    }
    return samples;
}

bool liesIn(const Bounds& inner, const Bounds& outer) {
    return contains(outer, inner.low) && contains(outer, inner.high);
}

/// Shells that cross each other.
class CrossingShells {
  public:
    CrossingShells(const TriangleSoup& soup, const SoupShells& shells) {
        constexpr auto kAll = std::numeric_limits<std::size_t>::max();
        for (const auto& [a, b] : findCrossings(soup, kAll, &shells.ofTriangle)) {
            const std::pair<int, int> pair =
                std::minmax(shells.ofTriangle[a], shells.ofTriangle[b]);
            const bool alike = shells.volumes[pair.first] * shells.volumes[pair.second] > 0;
            // A cavity may touch the wall around it.
            if (alike || passThrough(cornersOf(soup, a), cornersOf(soup, b))) {
                pairs_.insert(pair);
            }
        }
    }
    bool cross(int a, int b) const { return pairs_.contains(std::minmax(a, b)); }

    /// How many solids these shells make, if those that cross were united.
    int united(const std::vector<int>& shells) const {
        UnionFind sets(shells.size());
        int count = static_cast<int>(shells.size());
        for (int i = 0; i < static_cast<int>(shells.size()); ++i) {
            for (int k = 0; k < i; ++k) {
                if (cross(shells[i], shells[k]) && sets.root(i) != sets.root(k)) {
                    sets.join(i, k);
                    --count;
                }
            }
        }
        return count;
    }

  private:
    std::set<std::pair<int, int>> pairs_;
};

/// Finds in which other shells each lies.
class Nesting {
  public:
    Nesting(const TriangleSoup& soup, const SoupShells& shells) : soup_(soup), shells_(shells) {}

    std::vector<int> depths() const {
        std::vector<std::vector<int>> around = boxesAround();
        keepThoseAroundSamples(around);
        if (std::ranges::all_of(around, [](const auto& shells) { return shells.empty(); })) {
            return std::vector<int>(around.size(), 0);
        }
        const CrossingShells crossing(soup_, shells_);
        std::vector<int> depths;
        for (int shell = 0; shell < shells_.size(); ++shell) {
            std::erase_if(around[shell], [&](int other) { return crossing.cross(shell, other); });
            depths.push_back(crossing.united(around[shell]));
        }
        return depths;
    }

  private:
    std::vector<std::vector<int>> boxesAround() const {
        std::vector<int> all(shells_.bounds.size());
        std::iota(all.begin(), all.end(), 0);
        const BoxTree::BoundsOf boundsOf = [this](int shell) { return shells_.bounds[shell]; };
        BoxTree tree(all, boundsOf);
        std::vector<std::vector<int>> around(all.size());
        for (const int shell : all) {
            const Bounds& own = shells_.bounds[shell];
            const auto mayHold = [&](const Bounds& box) { return liesIn(own, box); };
            tree.find(boundsOf, mayHold, [&](int other) {
                if (other != shell && liesIn(own, shells_.bounds[other])) {
                    around[shell].push_back(other);
                }
            });
        }
        return around;
    }

    void keepThoseAroundSamples(std::vector<std::vector<int>>& around) const {
        const auto nested =
            std::ranges::count_if(around, [](const auto& shells) { return !shells.empty(); });
        const auto tests =
            static_cast<double>(nested * static_cast<std::ptrdiff_t>(soup_.triangles.size()));
        const int samples = std::max(kLeastSamples, static_cast<int>(kMostTests / (tests + 1)));
        for (int shell = 0; shell < shells_.size(); ++shell) {
            for (const int t : samplesOf(shells_, shell, samples)) {
                if (around[shell].empty()) {
                    break;
                }
                keepThoseAround(pointInside(cornersOf(soup_, t)), around[shell]);
            }
        }
    }

    /// Removes from `around` the shells that do not surround the point.
    void keepThoseAround(const Vec3& point, std::vector<int>& around) const {
        std::vector<int> winding(shells_.bounds.size(), 0);
        std::vector<char> asked(shells_.bounds.size(), 0);
        for (const int shell : around) {
            asked[shell] = 1;
        }
        for (int t = 0; t < static_cast<int>(soup_.triangles.size()); ++t) {
            if (asked[shells_.ofTriangle[t]] != 0) {
                winding[shells_.ofTriangle[t]] += rayCrossing(cornersOf(soup_, t), point);
            }
        }
        std::erase_if(around, [&](int shell) { return winding[shell] == 0; });
    }

    const TriangleSoup& soup_;
    const SoupShells& shells_;
};

}  // namespace

SoupShells measureShells(const TriangleSoup& soup, const Vec3& middle) {
    UnionFind vertices(soup.positions.size());
    for (const auto& [a, b, c] : soup.triangles) {
        vertices.join(a, b);
        vertices.join(b, c);
    }
    SoupShells shells;
    std::vector<int> shellOfRoot(soup.positions.size(), -1);
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        int& shell = shellOfRoot[vertices.root(soup.triangles[t][0])];
        if (shell < 0) {
            shell = addShell(shells, t);
        }
        shells.ofTriangle.push_back(shell);
        const Corners at = cornersOf(soup, t);
        shells.volumes[shell] += tetrahedronVolume(at[0] - middle, at[1] - middle, at[2] - middle);
        shells.areas[shell] += triangleArea(at);
        ++shells.counts[shell];
        for (const Vec3& corner : at) {
            shells.bounds[shell].add(corner);
        }
    }
    return shells;
}

std::vector<int> nestingDepths(const TriangleSoup& soup, const SoupShells& shells) {
    return Nesting(soup, shells).depths();
}

}  // namespace kerf::repair
