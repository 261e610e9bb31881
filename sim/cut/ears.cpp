#include "sim/cut/ears.h"

#include <algorithm>
#include <optional>
#include <set>

namespace kerf::cut {

namespace {

// Share of h below which an ear closes a coincident edge and goes first.
constexpr double kTinyEar = 1e-7;
constexpr double kTinyEarQuality = 2;
constexpr double kBlockedEarPenalty = 5;

class EarCutter {
  public:
    EarCutter(const std::vector<Node>& nodes, double h) : nodes_(nodes), h_(h) {}

    std::vector<Triangle> run(const Sheet2d& sheet) {
        polygon_ = nodesOf(sheet.outer);
        for (const Loop& hole : sheet.holes) {
            bridge(nodesOf(hole));
        }
        if (polygon_.size() < 3) {
            throw StepFailure{"a loop of the wall has two edges"};
        }
        for (int i = 0; i < sizeOf(polygon_); ++i) {
            used_.insert({polygon_[i], around(i + 1)});
        }
        while (polygon_.size() > 3) {
            cut(bestEar());
        }
        requireTriangle();
        triangles_.push_back({polygon_[0], polygon_[1], polygon_[2]});
        return triangles_;
    }

  private:
    static std::vector<int> nodesOf(const Loop& loop) {
        std::vector<int> result;
        for (const OutlineEdge& edge : loop) {
            result.push_back(edge.from);
        }
        return result;
    }

    const Vec2& at(int node) const { return nodes_[node].layout; }

    int around(int i) const {
        const int n = sizeOf(polygon_);
        return polygon_[(i + n) % n];
    }

    // polygon 0..i, hole j..j, polygon i..end
    void bridge(const std::vector<int>& hole) {
        double nearest = 1e300;
        std::size_t bestI = 0;
        std::size_t bestJ = 0;
        for (std::size_t i = 0; i < polygon_.size(); ++i) {
            for (std::size_t j = 0; j < hole.size(); ++j) {
                const double distance = (at(polygon_[i]) - at(hole[j])).norm();
                if (polygon_[i] != hole[j] && distance < nearest) {
                    nearest = distance;
                    bestI = i;
                    bestJ = j;
                }
            }
        }
        std::vector<int> joined(polygon_.begin(), polygon_.begin() + static_cast<long>(bestI) + 1);
        for (std::size_t j = 0; j <= hole.size(); ++j) {
            joined.push_back(hole[(bestJ + j) % hole.size()]);
        }
        joined.insert(joined.end(), polygon_.begin() + static_cast<long>(bestI), polygon_.end());
        polygon_ = joined;
    }

    bool isUsed(int a, int b) const { return used_.count({a, b}) > 0 || used_.count({b, a}) > 0; }

    double doubleArea(int a, int b, int c) const {
        const Vec2 u = at(b) - at(a);
        const Vec2 v = at(c) - at(a);
        return u.x() * v.y() - u.y() * v.x();
    }

    bool blocked(int a, int b, int c) const {
        return std::any_of(polygon_.begin(), polygon_.end(), [&](int d) {
            return d != a && d != b && d != c && doubleArea(a, b, d) >= 0 &&
                   doubleArea(b, c, d) >= 0 && doubleArea(c, a, d) >= 0 &&
                   (at(d) - at(a)).norm() > kTinyEar * h_ && (at(d) - at(c)).norm() > kTinyEar * h_;
        });
    }

    std::optional<double> quality(int i) const {
        const int a = around(i - 1), b = around(i), c = around(i + 1);
        if (a == b || b == c || a == c || isUsed(a, c)) {
            return {};
        }
        const double longest = std::max(
            {(at(a) - at(b)).norm(), (at(b) - at(c)).norm(), (at(a) - at(c)).norm(), 1e-300});
        if (longest < kTinyEar * h_) {
            return kTinyEarQuality;
        }
        const double shape = doubleArea(a, b, c) / (longest * longest);
        if (shape <= 0) {
            return 2 * shape - 2;
        }
        return blocked(a, b, c) ? shape - kBlockedEarPenalty : shape;
    }

    int bestEar() const {
        int best = -1;
        double bestQuality = -1e300;
        for (int i = 0; i < sizeOf(polygon_); ++i) {
            const std::optional<double> found = quality(i);
            if (found && *found > bestQuality) {
                bestQuality = *found;
                best = i;
            }
        }
        if (best < 0) {
            throw StepFailure{"the wall has no ear"};
        }
        return best;
    }

    void cut(int i) {
        const int a = around(i - 1), b = around(i), c = around(i + 1);
        triangles_.push_back({a, b, c});
        used_.insert({a, c});
        used_.insert({c, a});
        polygon_.erase(polygon_.begin() + i);
    }

    void requireTriangle() const {
        if (polygon_[0] == polygon_[1] || polygon_[1] == polygon_[2] ||
            polygon_[0] == polygon_[2]) {
            throw StepFailure{"the last ear of the wall is no triangle"};
        }
    }

    const std::vector<Node>& nodes_;
    double h_;
    std::vector<int> polygon_;
    std::set<std::pair<int, int>> used_;
    std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> cutEars(const Sheet2d& sheet, const std::vector<Node>& nodes, double h) {
    return EarCutter(nodes, h).run(sheet);
}

}  // namespace kerf::cut
