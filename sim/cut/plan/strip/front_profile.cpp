#include "sim/cut/plan/strip/front_profile.h"

#include "sim/cut/surface/broad_phase.h"

namespace kerf::cut {

namespace {

constexpr double kRoom = 1e-11;  // share of the largest coordinate

/// Of the line through p and q, at x.
double heightOfLine(const Vec2& p, const Vec2& q, double x) {
    return p.y() + (q.y() - p.y()) * ((x - p.x()) / (q.x() - p.x()));
}

/// The highest point at x of a triangle's edges that do not end in `corner` (-1 for none); far
/// below where none gets there.
double topOf(const std::array<Vec2, 3>& corners, int corner, double x) {
    double top = -1e300;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const Vec2& p = corners[i];
        const Vec2& q = corners[j];
        if (i != corner && j != corner && (p.x() < x) != (q.x() < x)) {
            top = std::max(top, heightOfLine(p, q, x));
        }
    }
    return top;
}

}  // namespace

FrontProfile::FrontProfile(const Blade& blade, const Strip& strip) : strip_(strip) {
    std::vector<Vec3> points;
    points.reserve(strip.nodes.size());
    for (const StripNode& node : strip.nodes) {
        points.push_back(node.position);
        room_ = std::max(room_, kRoom * node.position.cwiseAbs().maxCoeff());
    }
    const Eigen::Matrix3d axes = sweptAxes(blade, points);
    along_ = axes.col(0);
    ahead_ = -axes.col(1);
    front_.reserve(strip.oldCount);
    for (int i = 0; i < strip.oldCount; ++i) {
        front_.push_back(flat(points[i]));
        highest_ = std::max(highest_, front_.back().y());
    }
    if (!runsOn() ||
        !std::ranges::all_of(strip.edges, [this](const StripEdge& e) { return isUnder(e); })) {
        front_.clear();
    }
    if (sizeOf(front_) >= 2) {
        nodesPerLength_ = (sizeOf(front_) - 1) / (front_.back().x() - front_.front().x());
    }
}

bool FrontProfile::runsOn() const {
    const auto goesBack = [this](const Vec2& p, const Vec2& q) { return !(q.x() - p.x() > room_); };
    return std::ranges::adjacent_find(front_, goesBack) == front_.end();
}

/// Whether an edge of the strip lies above the old rung wherever it is not part of it.
bool FrontProfile::isUnder(const StripEdge& edge) const {
    const bool oldA = strip_.isOld(edge.a);
    const bool oldB = strip_.isOld(edge.b);
    if (oldA && oldB) {
        return std::abs(edge.a - edge.b) == 1;
    }
    const Vec2 a = flat(strip_.nodes[edge.a].position);
    const Vec2 b = flat(strip_.nodes[edge.b].position);
    if ((!oldA && a.y() - highest_ <= room_) || (!oldB && b.y() - highest_ <= room_)) {
        return false;
    }
    return oldA ? isUnderLine(edge.a, b) : !oldB || isUnderLine(edge.b, a);
}

/// Whether the other nodes lie under the line from a node to `end`.
bool FrontProfile::isUnderLine(int node, const Vec2& end) const {
    const Vec2& start = front_[node];
    const int step = end.x() > start.x() ? 1 : -1;
    for (int k = node + step; k >= 0 && k < sizeOf(front_); k += step) {
        const double x = front_[k].x();
        if (step * (end.x() - x) < 0) {
            break;
        }
        if (!(heightOfLine(start, end, x) - front_[k].y() > room_)) {
            return false;
        }
    }
    return true;
}

/// The first node that does not come before x, which lies between the ends. Nodes are about evenly
/// spaced.
int FrontProfile::firstFrom(double x) const {
    const int last = sizeOf(front_) - 1;
    int first = std::min(last, static_cast<int>((x - front_.front().x()) * nodesPerLength_));
    while (first > 0 && front_[first - 1].x() >= x) {
        --first;
    }
    while (first < last && front_[first].x() < x) {
        ++first;
    }
    return first;
}

bool FrontProfile::isSeenAt(int node, int vertex, const Vec3& at) const {
    const StripNode& n = strip_.nodes[node];
    return n.position == at && std::ranges::find(n.vertices, vertex) != n.vertices.end();
}

/// `next`: none of the nodes before it lies at x or beyond.
double FrontProfile::heightAt(double x, int next) const {
    while (front_[next].x() < x) {
        ++next;
    }
    next = std::max(1, next);
    return heightOfLine(front_[next - 1], front_[next], x);
}

// Both the rung and the top of the triangle run straight between their corners, so one lies under
// the other where it does at the corners of both.
bool FrontProfile::isBehind(const Triangle& ids, const Corners& at) const {
    if (sizeOf(front_) < 2) {
        return false;
    }
    const std::array<Vec2, 3> corners{flat(at[0]), flat(at[1]), flat(at[2])};
    const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
    if (left < front_.front().x() || right > front_.back().x()) {
        return false;
    }
    const int first = firstFrom(left);
    std::array<bool, 3> isNode{};
    for (int k = first; k < sizeOf(front_) && front_[k].x() <= right; ++k) {
        int corner = -1;
        for (int i = 0; i < 3; ++i) {
            if (isSeenAt(k, ids[i], at[i])) {
                isNode[i] = true;
                corner = i;
            }
        }
        if (!(front_[k].y() - topOf(corners, corner, front_[k].x()) > room_)) {
            return false;
        }
    }
    for (int i = 0; i < 3; ++i) {
        if (!isNode[i] && !(heightAt(corners[i].x(), first) - corners[i].y() > room_)) {
            return false;
        }
    }
    return true;
}

}  // namespace kerf::cut
