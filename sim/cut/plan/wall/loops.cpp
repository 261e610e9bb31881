#include "sim/cut/plan/wall/loops.h"

namespace kerf::cut {

namespace {

// A loop whose area is below this share of its squared length has none.
constexpr double kZeroArea = 1e-12;
// A clockwise loop without an outer one is accepted as a sheet when it is this thin (share of h).
constexpr double kThinSheet = 1e-4;
constexpr double kSameAngle = 1e-12;

double angleTo(const Vec2& from, const Vec2& to) {
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

class LoopNesting {
  public:
    LoopNesting(const StepInput& in, const Outline& outline, const std::vector<CutNode>& nodes)
        : in_(in), edges_(outline.edges), nodes_(nodes) {}

    std::vector<Sheet2d> run() {
        pairEdges();
        chain();
        for (const Loop& loop : loops_) {
            areas_.push_back(areaOf(loop));
        }
        parents_.assign(loops_.size(), -1);
        for (int i = 0; i < sizeOf(loops_); ++i) {
            if (areas_[i] <= 0) {
                parents_[i] = findParent(i);
            }
        }
        return sheets();
    }

  private:
    const Vec2& at(int node) const { return nodes_[node].layout; }

    // Every in-edge of a node is followed by one out-edge: the first clockwise that is still free.
    // A wrong choice at a crossing can then never leave a loop open.
    void pairEdges() {
        std::vector<int> firstLeaving(nodes_.size(), -1);
        nextLeaving_.assign(edges_.size(), -1);
        for (int i = sizeOf(edges_) - 1; i >= 0; --i) {
            nextLeaving_[i] = std::exchange(firstLeaving[edges_[i].from], i);
        }
        std::vector<bool> taken(edges_.size(), false);
        for (const OutlineEdge& edge : edges_) {
            const int next = firstClockwise(edge, firstLeaving[edge.to], taken);
            if (next < 0) {
                throw StepFailure{"a loop of the wall is open"};
            }
            taken[next] = true;
            nextEdge_.push_back(next);
        }
    }

    /// Of the edges that leave where `edge` ends: `candidate` and those after it.
    int firstClockwise(const OutlineEdge& edge, int candidate,
                       const std::vector<bool>& taken) const {
        if (candidate >= 0 && nextLeaving_[candidate] < 0) {
            return taken[candidate] ? -1 : candidate;
        }
        const double full = 2 * std::numbers::pi;
        const double back = angleTo(at(edge.to), at(edge.from));
        int best = -1;
        double bestTurn = 1e9;
        for (; candidate >= 0; candidate = nextLeaving_[candidate]) {
            if (taken[candidate]) {
                continue;
            }
            double turn = back - angleTo(at(edge.to), at(edges_[candidate].to));
            while (turn <= kSameAngle) {
                turn += full;
            }
            while (turn > full + kSameAngle) {
                turn -= full;
            }
            if (turn < bestTurn) {
                bestTurn = turn;
                best = candidate;
            }
        }
        return best;
    }

    void chain() {
        std::vector<bool> used(edges_.size(), false);
        for (int i = 0; i < sizeOf(edges_); ++i) {
            if (used[i]) {
                continue;
            }
            Loop loop;
            for (int k = i; !used[k]; k = nextEdge_[k]) {
                used[k] = true;
                loop.push_back(edges_[k]);
            }
            loops_.push_back(loop);
        }
    }

    double areaOf(const Loop& loop) const {
        const Vec2& origin = at(loop.front().from);
        double area = 0;
        double length = 0;
        for (const OutlineEdge& edge : loop) {
            const Vec2 p = at(edge.from) - origin;
            const Vec2 q = at(edge.to) - origin;
            area += 0.5 * cross2(p, q);
            length += (q - p).norm();
        }
        return std::fabs(area) < kZeroArea * length * length ? 0.0 : area;
    }

    bool contains(const Loop& loop, const Vec2& p) const {
        bool inside = false;
        for (const OutlineEdge& edge : loop) {
            const Vec2& a = at(edge.from);
            const Vec2& b = at(edge.to);
            if ((a.y() > p.y()) != (b.y() > p.y()) &&
                p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
                inside = !inside;
            }
        }
        return inside;
    }

    bool mostlyInside(const Loop& inner, const Loop& outer) const {
        int inside = 0;
        for (const OutlineEdge& edge : inner) {
            inside += contains(outer, at(edge.from));
        }
        return 2 * inside > sizeOf(inner);
    }

    int findParent(int hole) const {
        int parent = -1;
        for (int i = 0; i < sizeOf(loops_); ++i) {
            const bool smaller = parent < 0 || areas_[i] < areas_[parent];
            const bool ofPiece = loops_[i].front().piece == loops_[hole].front().piece;
            if (i != hole && areas_[i] > 0 && smaller && ofPiece &&
                mostlyInside(loops_[hole], loops_[i])) {
                parent = i;
            }
        }
        if (parent < 0) {
            requireThin(hole);
        }
        return parent;
    }

    void requireThin(int loop) const {
        double length = 0;
        for (const OutlineEdge& edge : loops_[loop]) {
            length += (nodes_[edge.to].position - nodes_[edge.from].position).norm();
        }
        if (areas_[loop] < -kThinSheet * in_.h * std::max(length, in_.h)) {
            throw StepFailure{"a hole of the wall has no loop around it"};
        }
    }

    std::vector<Sheet2d> sheets() const {
        std::vector<Sheet2d> result;
        for (int i = 0; i < sizeOf(loops_); ++i) {
            if (parents_[i] >= 0) {
                continue;
            }
            Sheet2d sheet{loops_[i], {}};
            for (int j = 0; j < sizeOf(loops_); ++j) {
                if (parents_[j] == i) {
                    sheet.holes.push_back(loops_[j]);
                }
            }
            result.push_back(sheet);
        }
        return result;
    }

    const StepInput& in_;
    const std::vector<OutlineEdge>& edges_;
    const std::vector<CutNode>& nodes_;
    std::vector<int> nextLeaving_;  ///< of each edge: the next one from the same node, or -1
    std::vector<int> nextEdge_;
    std::vector<Loop> loops_;
    std::vector<double> areas_;
    std::vector<int> parents_;
};

}  // namespace

std::vector<Sheet2d> nestLoops(const StepInput& in, const Outline& outline,
                               const std::vector<CutNode>& nodes) {
    return LoopNesting(in, outline, nodes).run();
}

}  // namespace kerf::cut
