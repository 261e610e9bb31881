#include "sim/cut/plan/wall/ears.h"

#include "sim/base/containers.h"

namespace kerf::cut {

namespace {

// Share of h below which an ear closes a coincident edge and goes first.
constexpr double kTinyEar = 1e-7;
constexpr double kTinyEarQuality = 2;
constexpr double kBlockedEarPenalty = 5;

class EarCutter {
  public:
    EarCutter(const std::vector<CutNode>& nodes, double h) : nodes_(nodes), h_(h) {}

    std::vector<Triangle> run(const Sheet2d& sheet) {
        polygon_ = nodesOf(sheet.outer);
        bridgeAll(sheet.holes);
        if (polygon_.size() < 3) {
            throw StepFailure{"a loop of the wall has two edges"};
        }
        for (int i = 0; i < sizeOf(polygon_); ++i) {
            used_.insert({polygon_[i], around(i + 1)});
        }
        for (int i = 0; i < sizeOf(polygon_); ++i) {
            ears_.push_back(earAt(i));
        }
        while (polygon_.size() > 3) {
            cut(bestEar());
        }
        requireTriangle();
        triangles_.push_back({polygon_[0], polygon_[1], polygon_[2]});
        return triangles_;
    }

  private:
    static std::vector<int> nodesOf(const Loop& loop) { return mapped(loop, &OutlineEdge::from); }

    const Vec2& at(int node) const { return nodes_[node].layout; }

    int around(int i) const {
        const int n = sizeOf(polygon_);
        return polygon_[(i + n) % n];
    }

    struct Bridge {
        double length = 1e300;
        std::size_t i = 0;  ///< in the polygon
        std::size_t j = 0;  ///< in the hole
    };

    // The nearest hole first, or a bridge could run across one that is not joined yet.
    void bridgeAll(const std::vector<Loop>& loops) {
        std::vector<std::vector<int>> holes = mapped(loops, nodesOf);
        while (!holes.empty()) {
            std::size_t nearest = 0;
            Bridge best;
            for (std::size_t k = 0; k < holes.size(); ++k) {
                const Bridge bridge = shortestBridge(holes[k]);
                if (bridge.length < best.length) {
                    best = bridge;
                    nearest = k;
                }
            }
            join(holes[nearest], best);
            holes.erase(holes.begin() + static_cast<long>(nearest));
        }
    }

    Bridge shortestBridge(const std::vector<int>& hole) const {
        Bridge best;
        for (std::size_t i = 0; i < polygon_.size(); ++i) {
            for (std::size_t j = 0; j < hole.size(); ++j) {
                const double length = (at(polygon_[i]) - at(hole[j])).norm();
                if (polygon_[i] != hole[j] && length < best.length) {
                    best = {length, i, j};
                }
            }
        }
        return best;
    }

    // polygon 0..i, hole j..j, polygon i..end
    void join(const std::vector<int>& hole, const Bridge& bridge) {
        const auto i = polygon_.begin() + static_cast<long>(bridge.i);
        std::vector<int> joined(polygon_.begin(), i + 1);
        for (std::size_t j = 0; j <= hole.size(); ++j) {
            joined.push_back(hole[(bridge.j + j) % hole.size()]);
        }
        joined.insert(joined.end(), i, polygon_.end());
        polygon_ = joined;
    }

    bool isUsed(int a, int b) const { return used_.count({a, b}) > 0 || used_.count({b, a}) > 0; }

    double doubleArea(int a, int b, int c) const { return cross2(at(b) - at(a), at(c) - at(a)); }

    /// A node of the polygon in the triangle, -1 for none.
    int blocker(int a, int b, int c) const {
        const auto found = std::find_if(polygon_.begin(), polygon_.end(), [&](int d) {
            return d != a && d != b && d != c && doubleArea(a, b, d) >= 0 &&
                   doubleArea(b, c, d) >= 0 && doubleArea(c, a, d) >= 0 &&
                   (at(d) - at(a)).norm() > kTinyEar * h_ && (at(d) - at(c)).norm() > kTinyEar * h_;
        });
        return found == polygon_.end() ? -1 : *found;
    }

    /// What is known of the ear at a place of the polygon; it holds until a neighbour or the
    /// blocker goes.
    struct Ear {
        std::optional<double> quality;  ///< none: no ear
        int blocker = -1;
    };

    Ear earAt(int i) const {
        const int a = around(i - 1), b = around(i), c = around(i + 1);
        if (a == b || b == c || a == c || isUsed(a, c)) {
            return {};
        }
        const double longest = std::max(
            {(at(a) - at(b)).norm(), (at(b) - at(c)).norm(), (at(a) - at(c)).norm(), 1e-300});
        if (longest < kTinyEar * h_) {
            return {kTinyEarQuality, -1};
        }
        const double shape = doubleArea(a, b, c) / (longest * longest);
        if (shape <= 0) {
            return {2 * shape - 2, -1};
        }
        const int inside = blocker(a, b, c);
        return {inside >= 0 ? shape - kBlockedEarPenalty : shape, inside};
    }

    int bestEar() {
        for (;;) {
            int best = -1;
            for (int i = 0; i < sizeOf(ears_); ++i) {
                if (ears_[i].quality && (best < 0 || *ears_[i].quality > *ears_[best].quality)) {
                    best = i;
                }
            }
            if (best < 0) {
                throw StepFailure{"the wall has no ear"};
            }
            if (!isUsed(around(best - 1), around(best + 1))) {
                return best;
            }
            ears_[best].quality.reset();  // an ear cut since has taken its edge
        }
    }

    void cut(int i) {
        const int a = around(i - 1), b = around(i), c = around(i + 1);
        triangles_.push_back({a, b, c});
        used_.insert({a, c});
        used_.insert({c, a});
        polygon_.erase(polygon_.begin() + i);
        ears_.erase(ears_.begin() + i);
        const int n = sizeOf(polygon_);
        for (int k = 0; k < n; ++k) {
            if (k == (i + n - 1) % n || k == i % n || ears_[k].blocker == b) {
                ears_[k] = earAt(k);
            }
        }
    }

    void requireTriangle() const {
        if (polygon_[0] == polygon_[1] || polygon_[1] == polygon_[2] ||
            polygon_[0] == polygon_[2]) {
            throw StepFailure{"the last ear of the wall is no triangle"};
        }
    }

    const std::vector<CutNode>& nodes_;
    double h_;
    std::vector<int> polygon_;
    std::vector<Ear> ears_;  ///< by place in the polygon
    std::set<std::pair<int, int>> used_;
    std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> cutEars(const Sheet2d& sheet, const std::vector<CutNode>& nodes, double h) {
    return EarCutter(nodes, h).run(sheet);
}

}  // namespace kerf::cut
