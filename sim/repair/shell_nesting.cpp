#include "sim/repair/shell_nesting.h"

#include <tuple>

#include "sim/base/math.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/winding.h"
#include "sim/repair/crossings.h"
#include "sim/repair/soup_editing.h"
#include "sim/repair/surface_contact.h"

namespace kerf::repair {

namespace {

void addShell(SoupShells& shells) {
    shells.volumes.push_back(0);
    shells.areas.push_back(0);
    shells.bounds.emplace_back();
}

/// 0 to count - 1.
std::vector<int> numbersBelow(std::size_t count) {
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

bool liesIn(const Bounds& inner, const Bounds& outer) {
    return contains(outer, inner.low) && contains(outer, inner.high);
}

/// Shells that cross each other.
class CrossingShells {
  public:
    CrossingShells(const TriangleSoup& soup, const SoupShells& shells) : others_(shells.size()) {
        constexpr auto kAll = std::numeric_limits<std::size_t>::max();
        for (const auto& [a, b] : findCrossings(soup, kAll, &shells.ofTriangle)) {
            const int first = shells.ofTriangle[a];
            const int second = shells.ofTriangle[b];
            const bool alike = shells.volumes[first] * shells.volumes[second] > 0;
            // A cavity may touch the wall around it.
            if (alike || passThrough(cornersOf(soup, a), cornersOf(soup, b))) {
                others_[first].insert(second);
                others_[second].insert(first);
            }
        }
    }
    /// Those that a shell crosses.
    const std::set<int>& of(int shell) const { return others_[shell]; }

  private:
    std::vector<std::set<int>> others_;
};

/// The triangles of a soup, to look for those that a ray along x may meet.
class RayTargets {
  public:
    explicit RayTargets(const TriangleSoup& soup)
        : soup_(soup), tree_(numbersBelow(soup.triangles.size()), boundsOf_) {}

    /// How often each shell surrounds the point, of those that do.
    std::map<int, int> windings(const Vec3& point, const SoupShells& shells) {
        std::map<int, int> windings;
        const auto mayMeet = [&](const Bounds& box) {
            return box.low.y() <= point.y() && point.y() <= box.high.y() &&
                   box.low.z() <= point.z() && point.z() <= box.high.z() &&
                   box.high.x() >= point.x();
        };
        tree_.find(boundsOf_, mayMeet, [&](int t) {
            if (const int crossing = rayCrossing(cornersOf(soup_, t), point); crossing != 0) {
                windings[shells.ofTriangle[t]] += crossing;
            }
        });
        std::erase_if(windings, [](const auto& each) { return each.second == 0; });
        return windings;
    }

  private:
    const TriangleSoup& soup_;
    BoxTree::BoundsOf boundsOf_ = [this](int t) { return boundsOf(soup_, t); };
    BoxTree tree_;
};

/// Finds which shells lie around each, apart from those that it crosses.
class Surroundings {
  public:
    Surroundings(const TriangleSoup& soup, const SoupShells& shells)
        : soup_(soup), shells_(shells), triangles_(shells.size()) {
        for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
            triangles_[shells.ofTriangle[t]].push_back(t);
        }
    }

    /// By shell, those around it, those that it crosses still among them.
    std::vector<std::vector<int>> all() const {
        std::vector<std::vector<int>> around = boxesAround();
        if (std::ranges::all_of(around, [](const auto& each) { return each.empty(); })) {
            return around;
        }
        RayTargets targets(soup_);
        for (int shell = 0; shell < shells_.size(); ++shell) {
            if (!around[shell].empty()) {
                const std::map<int, int> windings = targets.windings(insideOf(shell), shells_);
                std::erase_if(around[shell], [&](int other) { return !windings.contains(other); });
            }
        }
        return around;
    }

  private:
    /// By shell the larger ones whose boxes hold its own.
    std::vector<std::vector<int>> boxesAround() const {
        const std::vector<int> all = numbersBelow(shells_.size());
        const BoxTree::BoundsOf boundsOf = [this](int shell) { return shells_.bounds[shell]; };
        BoxTree tree(all, boundsOf);
        std::vector<std::vector<int>> around(all.size());
        for (const int shell : all) {
            const Bounds& own = shells_.bounds[shell];
            const auto mayHold = [&](const Bounds& box) { return liesIn(own, box); };
            tree.find(boundsOf, mayHold, [&](int other) {
                if (shells_.isLarger(other, shell) && liesIn(own, shells_.bounds[other])) {
                    around[shell].push_back(other);
                }
            });
        }
        return around;
    }

    /// The deepest of some points inside.
    Vec3 insideOf(int shell) const {
        constexpr int kTries = 3;
        const int inward = shells_.volumes[shell] < 0 ? -1 : 1;
        const auto forEach = [&](auto&& f) {
            for (const int t : triangles_[shell]) {
                f(cornersOf(soup_, t));
            }
        };
        InnerPoint best;
        for (int i = 0; i < kTries; ++i) {
            const int t = triangles_[shell][i * (triangles_[shell].size() - 1) / (kTries - 1)];
            const InnerPoint next = pointBehind(cornersOf(soup_, t), inward, forEach);
            best = i == 0 || next.depth > best.depth ? next : best;
        }
        return best.point;
    }

    const TriangleSoup& soup_;
    const SoupShells& shells_;
    std::vector<std::vector<int>> triangles_;  ///< by shell
};

/// Decides from the largest shell to the smallest what each bounds.
class Nesting {
  public:
    Nesting(const SoupShells& shells, std::vector<std::vector<int>> around,
            const CrossingShells& crossing)
        : shells_(shells), around_(std::move(around)), crossing_(crossing) {
        for (int shell = 0; shell < shells.size(); ++shell) {
            given_.push_back(shells.volumes[shell] < 0 ? -1 : 1);
            std::erase_if(around_[shell],
                          [&](int other) { return crossing.of(shell).contains(other); });
        }
        signs_ = given_;
    }

    ShellNesting decide() {
        std::vector<int> order = numbersBelow(shells_.size());
        std::ranges::sort(order, [&](int a, int b) { return shells_.isLarger(a, b); });
        for (const int shell : order) {
            signs_[shell] = isCavity(shell) ? -1 : 1;
        }
        ShellNesting nesting;
        for (int shell = 0; shell < shells_.size(); ++shell) {
            nesting.cavity.push_back(signs_[shell] < 0 ? 1 : 0);
            nesting.owner.push_back(signs_[shell] < 0 ? ownerOf(shell) : shell);
        }
        return nesting;
    }

  private:
    /// How often there is material around a shell, where it is in none that it crosses.
    int materialAround(int shell) const {
        return std::accumulate(around_[shell].begin(), around_[shell].end(), 0,
                               [&](int sum, int other) { return sum + signs_[other]; });
    }

    bool isCavity(int shell) const {
        const int around = materialAround(shell);
        // Where it crosses a cavity that was one in the file, it lies in that in part.
        const bool leavesMaterial = std::ranges::any_of(crossing_.of(shell), [&](int other) {
            return given_[other] < 0 && signs_[other] < 0 && around <= 1;
        });
        return around >= 1 && (given_[shell] < 0 || !leavesMaterial);
    }

    /// The smallest shell of material around a cavity.
    int ownerOf(int shell) const {
        int owner = shell;
        for (const int other : around_[shell]) {
            if (signs_[other] > 0 && (owner == shell || shells_.isLarger(owner, other))) {
                owner = other;
            }
        }
        return owner;
    }

    const SoupShells& shells_;
    std::vector<std::vector<int>> around_;
    const CrossingShells& crossing_;
    std::vector<int> given_;  ///< by shell: -1 where it faces inwards in the soup
    std::vector<int> signs_;  ///< -1 for a cavity, as far as decided; else as given
};

}  // namespace

bool SoupShells::isLarger(int a, int b) const {
    // Floats see a cavity and a core that fills it as equal; the cavity is around the core.
    const auto size = [&](int shell) { return static_cast<float>(std::abs(volumes[shell])); };
    const auto key = [&](int shell) { return std::tuple(-size(shell), volumes[shell] > 0, shell); };
    return key(a) < key(b);
}

bool SoupShells::isFlat(int shell) const {
    constexpr double kOfFloats = 1e-7;  // a place is off by at most that share of itself
    const Bounds& box = bounds[shell];
    const double far =
        (box.low - origin).cwiseAbs().cwiseMax((box.high - origin).cwiseAbs()).maxCoeff();
    return std::abs(volumes[shell]) <= kOfFloats * far * areas[shell];
}

SoupShells measureShells(const TriangleSoup& soup) {
    const Vec3 middle = boxOf(soup.positions).center();  // where rounding is smallest
    SoupShells shells;
    shells.origin = floatOrigin(soup);
    shells.ofTriangle = partsOf(soup);
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const int shell = shells.ofTriangle[t];
        if (shell == shells.size()) {
            addShell(shells);
        }
        const Corners at = cornersOf(soup, t);
        shells.volumes[shell] += tetrahedronVolume(at[0] - middle, at[1] - middle, at[2] - middle);
        shells.areas[shell] += triangleArea(at);
        shells.bounds[shell].add(boxOf(at));
    }
    return shells;
}

ShellNesting nestShells(const TriangleSoup& soup, const SoupShells& shells) {
    std::vector<std::vector<int>> around = Surroundings(soup, shells).all();
    if (std::ranges::all_of(around, [](const auto& each) { return each.empty(); })) {
        return {std::vector<char>(shells.size(), 0), numbersBelow(shells.size())};
    }
    return Nesting(shells, std::move(around), CrossingShells(soup, shells)).decide();
}

}  // namespace kerf::repair
