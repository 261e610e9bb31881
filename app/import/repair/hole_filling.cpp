#include "app/import/repair/hole_filling.h"

#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

using Edge = std::pair<int, int>;  // from, to
using Loop = std::vector<int>;

constexpr double kImpossible = std::numeric_limits<double>::infinity();

/// Sorted.
using Edges = std::vector<Edge>;

Edges directedEdges(const TriangleSoup& soup) {
    Edges edges;
    edges.reserve(3 * soup.triangles.size());
    for (const Triangle& t : soup.triangles) {
        for (int i = 0; i < 3; ++i) {
            edges.emplace_back(t[i], t[(i + 1) % 3]);
        }
    }
    std::ranges::sort(edges);
    return edges;
}

bool contains(const Edges& edges, int from, int to) {
    return std::ranges::binary_search(edges, Edge{from, to});
}

/// The next border vertex after each, in the direction that new triangles need: -1 for none, -2
/// where there is more than one way on.
std::vector<int> bordersOf(const Edges& edges, std::size_t vertices) {
    std::vector<int> next(vertices, -1);
    for (const auto& [from, to] : edges) {
        if (!contains(edges, to, from)) {
            next[to] = next[to] == -1 ? from : -2;
        }
    }
    return next;
}

/// Closed ways along the border, each once; ways through a vertex that has several are left out.
std::vector<Loop> loopsOf(const std::vector<int>& next) {
    std::vector<Loop> loops;
    std::vector<bool> seen(next.size(), false);
    for (int first = 0; first < static_cast<int>(next.size()); ++first) {
        Loop loop;
        int v = first;
        while (v >= 0 && next[v] >= 0 && !seen[v]) {
            seen[v] = true;
            loop.push_back(v);
            v = next[v];
        }
        if (loop.size() >= 3 && v == first) {
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

/// Barequet and Sharir: the best triangulation between two corners of the loop is the best triangle
/// over them with the best ones on its two sides.
class LoopFiller {
  public:
    LoopFiller(const TriangleSoup& soup, const Edges& edges, const Loop& loop)
        : soup_(soup),
          edges_(edges),
          loop_(loop),
          size_(static_cast<int>(loop.size())),
          cost_(loop.size() * loop.size(), 0),
          apex_(loop.size() * loop.size(), -1) {
        for (int span = 2; span < size_; ++span) {
            for (int i = 0; i + span < size_; ++i) {
                solve(i, i + span);
            }
        }
    }

    bool possible() const { return cost_[at(0, size_ - 1)] < kImpossible; }
    void appendTo(std::vector<Triangle>& triangles) const { append(0, size_ - 1, triangles); }

  private:
    std::size_t at(int i, int k) const { return static_cast<std::size_t>(i) * size_ + k; }

    void solve(int i, int k) {
        double best = kImpossible;
        const bool border = i == 0 && k == size_ - 1;
        if (border || isFree(i, k)) {
            for (int j = i + 1; j < k; ++j) {
                const double cost = cost_[at(i, j)] + cost_[at(j, k)] + areaOf(i, j, k);
                if (cost < best) {
                    best = cost;
                    apex_[at(i, k)] = j;
                }
            }
        }
        cost_[at(i, k)] = best;
    }

    /// No triangle of the mesh has this edge yet.
    bool isFree(int i, int k) const {
        return !contains(edges_, loop_[i], loop_[k]) && !contains(edges_, loop_[k], loop_[i]);
    }

    double areaOf(int i, int j, int k) const {
        const auto& at = soup_.positions;
        const Vec3 normal = areaNormal(at[loop_[i]], at[loop_[j]], at[loop_[k]]);
        return normal.isZero(0) ? kImpossible : 0.5 * normal.norm();
    }

    void append(int i, int k, std::vector<Triangle>& triangles) const {
        if (k - i < 2) {
            return;
        }
        const int j = apex_[at(i, k)];
        triangles.push_back({loop_[i], loop_[j], loop_[k]});
        append(i, j, triangles);
        append(j, k, triangles);
    }

    const TriangleSoup& soup_;
    const Edges& edges_;
    const Loop& loop_;
    int size_;
    std::vector<double> cost_;
    std::vector<int> apex_;
};

}  // namespace

HoleFilling fillHoles(TriangleSoup& welded) {
    const Edges edges = directedEdges(welded);
    const std::vector<Loop> loops = loopsOf(bordersOf(edges, welded.positions.size()));
    HoleFilling done;
    const std::size_t before = welded.triangles.size();
    for (const Loop& loop : loops) {
        if (loop.size() > kMostHoleEdges) {
            continue;
        }
        const LoopFiller filler(welded, edges, loop);
        if (filler.possible()) {
            filler.appendTo(welded.triangles);
            ++done.holes;
        }
    }
    done.triangles = static_cast<int>(welded.triangles.size() - before);
    resizeAttributes(welded.skin, welded.triangles.size());
    return done;
}

}  // namespace kerf::app
