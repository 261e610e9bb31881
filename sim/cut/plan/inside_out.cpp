#include "sim/cut/plan/inside_out.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::cut {

namespace {

// Two curve ends in impossible order are swapped when closer than this share of h: coincident or
// slightly inter-penetrating walls of an older slit.
constexpr double kTieDistance = 0.25;

/// Goes round the points and counts how often the body has been entered.
class InsideOut {
  public:
    InsideOut(const StepInput& in, const Strip& strip, std::vector<BorderPoint>& points)
        : in_(in), strip_(strip), points_(points) {}

    void run() {
        const auto hasEvent = [](const BorderPoint& p) { return p.event != 0; };
        const auto isOnFront = [this](const BorderPoint& p) { return p.isOnFront(strip_); };
        if (std::ranges::any_of(points_, [](auto& p) { return std::abs(p.event) > 1; })) {
            throw StepFailure{"two curves end at one point of the blade's border"};
        }
        if (std::ranges::any_of(points_, hasEvent)) {
            countWindings();
        } else {
            const bool inside = std::ranges::any_of(points_, isOnFront);
            std::ranges::for_each(points_, [&](BorderPoint& p) { p.inside = inside; });
        }
        for (const BorderPoint& point : points_) {
            if (isOnFront(point) && !point.inside) {
                throw StepFailure{"the front lies outside"};
            }
            if (point.inside && isInTheAir(point)) {
                throw StepFailure{"the air lies inside"};
            }
        }
    }

  private:
    /// A node of the blade far away from the body.
    bool isInTheAir(const BorderPoint& point) const {
        if (point.stripNode < 0 || in_.body.empty()) {
            return false;
        }
        const StripNode& node = strip_.nodes[point.stripNode];
        return node.vertices.empty() && !in_.body.overlaps({node.position, node.position});
    }

    /// A point of which it is known that nothing is inside there, -1 for none.
    int pointInTheAir() const {
        const auto found =
            std::ranges::find_if(points_, [this](auto& point) { return isInTheAir(point); });
        return found == points_.end() ? -1 : static_cast<int>(found - points_.begin());
    }

    /// The point behind the lowest sum of events.
    int lowestPoint() const {
        int lowest = 0;
        int sum = 0;
        int first = 0;
        for (int i = 0; i < sizeOf(points_); ++i) {
            sum += points_[i].event;
            if (sum < lowest) {
                lowest = sum;
                first = (i + 1) % sizeOf(points_);
            }
        }
        return first;
    }

    /// 0, unless the front says otherwise.
    int windingBefore(int first) const {
        int winding = 0;
        for (int k = 0; k < sizeOf(points_); ++k) {
            const BorderPoint& point = points_[(first + k) % sizeOf(points_)];
            winding += point.event;
            if (point.isOnFront(strip_) && winding < 1) {
                return 1;
            }
        }
        return 0;
    }

    void countWindings() {
        const int n = sizeOf(points_);
        const int inAir = pointInTheAir();
        const int first = inAir >= 0 ? inAir : lowestPoint();
        int winding = inAir >= 0 ? 0 : windingBefore(first);
        for (int k = 0; k < n; ++k) {
            const int i = (first + k) % n;
            if (k + 1 < n) {
                swapIfImpossible(points_[i], points_[(i + 1) % n], winding);
            }
            winding += points_[i].event;
            if (winding < 0 || winding > 1) {
                throw StepFailure{"the blade's border enters the body twice"};
            }
            points_[i].inside = winding == 1;
        }
    }

    void swapIfImpossible(BorderPoint& here, BorderPoint& next, int winding) const {
        const bool between = here.stripNode < 0 && next.stripNode < 0 && here.edge == next.edge;
        const bool impossible =
            (winding == 1 && here.event == 1) || (winding == 0 && here.event == -1);
        if (!between || !impossible || next.event != -here.event) {
            return;
        }
        const StripEdge& edge = strip_.edges[here.edge];
        const double length =
            (strip_.nodes[edge.a].position - strip_.nodes[edge.b].position).norm();
        if (std::fabs(next.u - here.u) * length < kTieDistance * in_.h) {
            std::swap(here, next);
        }
    }

    const StepInput& in_;
    const Strip& strip_;
    std::vector<BorderPoint>& points_;
};

}  // namespace

std::vector<BorderPoint> tellInsideOut(const StepInput& in, const Strip& strip,
                                       std::vector<BorderPoint> points) {
    InsideOut(in, strip, points).run();
    return points;
}

}  // namespace kerf::cut
