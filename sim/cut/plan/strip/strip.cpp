#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

namespace {

// Longest edge along the rung over the height of the row: flatter triangles are badly shaped.
constexpr double kFlattest = 2;
constexpr double kNoFront = 1e30;  // [m]

/// Distances of the nodes along the blade to the nearer end of their chain of front edges.
std::vector<double> distancesFromRim(const std::vector<StripNode>& rung, double bladeLength) {
    std::vector<double> distances(rung.size(), 0);
    bool hasFront = false;
    for (int i = 0; i < sizeOf(rung); ++i) {
        int last = i;
        while (last + 1 < sizeOf(rung) && rung[last].attached) {
            ++last;
        }
        hasFront |= last > i;
        for (int k = i; k <= last; ++k) {
            distances[k] = bladeLength * std::min(rung[k].s - rung[i].s, rung[last].s - rung[k].s);
        }
        i = last;
    }
    return hasFront ? distances : std::vector<double>(rung.size(), kNoFront);
}

/// Front edges join vertices of one piece only, so what is left of a gap joins nothing.
void dropGap(std::vector<char>& attachedWithin, int vertex) {
    if (!attachedWithin.empty()) {
        const int gap = std::min(vertex, sizeOf(attachedWithin) - 1);
        attachedWithin.erase(attachedWithin.begin() + gap);
    }
}

// A point counts as inside a triangle of the strip a little beyond it (share of the blade).
constexpr double kRoomInStrip = 1e-6;

}  // namespace

RungSpacing::RungSpacing(const StepInput& in, const std::vector<StripNode>& oldRung)
    : grading_(in.grading) {
    if (!grading_.isOn()) {
        return;
    }
    const std::vector<double> fromRim = distancesFromRim(oldRung, lengthOf(in.blade));
    for (int i = 0; i < sizeOf(oldRung); ++i) {
        const StripNode& node = oldRung[i];
        const double height = across(in.blade, node.position - in.blade.a).norm();
        places_.push_back({node.s, fromRim[i], height});
    }
}

double RungSpacing::at(double s, double edge) const {
    if (places_.size() < 2) {
        return edge;
    }
    const auto next = std::clamp(std::ranges::lower_bound(places_, s, {}, &RowHeight::s),
                                 places_.begin() + 1, places_.end() - 1);
    const RowHeight& p = *(next - 1);
    const RowHeight& q = *next;
    const double share = std::clamp((s - p.s) / (q.s - p.s), 0.0, 1.0);
    const double row = std::lerp(p.height, q.height, share);
    return std::min(grading_.lengthAt(edge, std::lerp(p.fromRim, q.fromRim, share)),
                    std::max(edge, kFlattest * row));
}

bool Strip::isNew(int node) const {
    return !isOld(node) || node == newRung.front() || node == newRung.back();
}

bool Strip::isRail(int edge) const {
    const Edge ends = edgeOf(edges[edge].a, edges[edge].b);
    return ends == edgeOf(0, newRung.front()) || ends == edgeOf(oldCount - 1, newRung.back());
}

bool Strip::onNewRung(int edge) const {
    const StripEdge& e = edges[edge];
    return isNew(e.a) && isNew(e.b) && !(isOld(e.a) && isOld(e.b)) && !isRail(edge);
}

Strip Strip::seenBy(int piece, const std::vector<int>& pieceOfVertex) const {
    const auto isOther = [&](int v) { return pieceOfVertex[v] != piece; };
    Strip strip = *this;
    for (StripNode& node : strip.nodes) {
        node.attached = node.attached && !isOther(node.vertices.back());
        for (int i = sizeOf(node.vertices) - 1; i >= 0; --i) {
            if (isOther(node.vertices[i])) {
                node.vertices.erase(node.vertices.begin() + i);
                dropGap(node.attachedWithin, i);
            }
        }
    }
    for (StripEdge& edge : strip.edges) {
        edge.frontOf = edge.frontOf == piece ? piece : -1;
    }
    return strip;
}

StripLocator::StripLocator(const Blade& blade, const Strip& strip)
    : strip_(strip), room_(kRoomInStrip * lengthOf(blade)) {
    double reach = -1e300;
    reachOfTriangle_.reserve(strip.triangles.size());
    for (const Triangle& t : strip.triangles) {
        for (const int node : t) {
            reach = std::max(reach, strip.nodes[node].layout.x());
        }
        reachOfTriangle_.push_back(reach);
    }
}

Vec3 StripLocator::at(const Vec2& p) const {
    const auto first = std::ranges::lower_bound(reachOfTriangle_, p.x() - room_);
    for (std::size_t i = first - reachOfTriangle_.begin(); i < strip_.triangles.size(); ++i) {
        const Triangle& t = strip_.triangles[i];
        const StripNode& a = strip_.nodes[t[0]];
        const StripNode& b = strip_.nodes[t[1]];
        const StripNode& c = strip_.nodes[t[2]];
        const Vec2 u = b.layout - a.layout;
        const Vec2 v = c.layout - a.layout;
        const double area = cross2(u, v);
        if (std::fabs(area) < 1e-300) {
            continue;
        }
        const double wb = cross2(p - a.layout, v) / area;
        const double wc = cross2(u, p - a.layout) / area;
        if (wb >= -1e-9 && wc >= -1e-9 && wb + wc <= 1 + 1e-9) {
            return (1 - wb - wc) * a.position + wb * b.position + wc * c.position;
        }
    }
    throw StepFailure{"an inner wall point lies outside the strip"};
}

}  // namespace kerf::cut
