#include "sim/cut/exact/triangulation.h"

#include "sim/base/predicates.h"

namespace kerf::cut {

namespace {

// Guards against cycling when the inexact in-circle test contradicts itself.
constexpr int kMostFlips = 5000;
constexpr int kMostConstraintFlips = 200000;
constexpr int kMostWalkSteps = 400;
// Relative size of the in-circle determinant that counts as inside.
constexpr double kInCircleMargin = 1e-12;

int nextCorner(int i) {
    return i == 2 ? 0 : i + 1;
}
int previousCorner(int i) {
    return i == 0 ? 2 : i - 1;
}

bool inCircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
    const Vec2 u = a - p;
    const Vec2 v = b - p;
    const Vec2 w = c - p;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
    const double vw1 = v.x() * w.y(), vw2 = v.y() * w.x();
    const double uw1 = u.x() * w.y(), uw2 = u.y() * w.x();
    const double uv1 = u.x() * v.y(), uv2 = u.y() * v.x();
    const double determinant = uu * (vw1 - vw2) - vv * (uw1 - uw2) + ww * (uv1 - uv2);
    if (!(determinant > 0)) {
        return false;
    }
    const double magnitude = uu * (std::fabs(vw1) + std::fabs(vw2)) +
                             vv * (std::fabs(uw1) + std::fabs(uw2)) +
                             ww * (std::fabs(uv1) + std::fabs(uv2));
    return determinant > kInCircleMargin * magnitude;
}

}  // namespace

Triangulation::Triangulation(const Vec2& a, const Vec2& b, const Vec2& c)
    : points_{a, b, c}, faceOfVertex_{0, 0, 0} {
    faces_.push_back({{0, 1, 2}, {-1, -1, -1}});
}

int Triangulation::cornerOf(int t, int v) const {
    for (int i = 0; i < 3; ++i) {
        if (faces_[t].corners[i] == v) {
            return i;
        }
    }
    return -1;
}

int Triangulation::mirrorEdge(int t, int e) const {
    return cornerOf(faces_[t].neighbors[e], faces_[t].corners[nextCorner(e)]);
}

int Triangulation::oppositeVertex(int t, int e) const {
    return faces_[faces_[t].neighbors[e]].corners[previousCorner(mirrorEdge(t, e))];
}

bool Triangulation::convex(int t, int e) const {
    if (faces_[t].neighbors[e] < 0) {
        return false;
    }
    const Vec2& a = points_[faces_[t].corners[e]];
    const Vec2& b = points_[faces_[t].corners[nextCorner(e)]];
    const Vec2& c = points_[faces_[t].corners[previousCorner(e)]];
    const Vec2& d = points_[oppositeVertex(t, e)];
    return orient2d(c, a, d) > 0 && orient2d(d, b, c) > 0;
}

// The neighbour across the directed edge from -> to of a divided triangle now is `neighbor`.
void Triangulation::linkNeighbor(int t, int from, int to, int neighbor) {
    if (t < 0) {
        return;
    }
    for (int e = 0; e < 3; ++e) {
        if (faces_[t].corners[e] == to && faces_[t].corners[nextCorner(e)] == from) {
            faces_[t].neighbors[e] = neighbor;
            return;
        }
    }
}

void Triangulation::remember(int t) {
    for (const int v : faces_[t].corners) {
        faceOfVertex_[v] = t;
    }
}

//     c                 c
//    / \               /|\        t = abc, other = bad
//   a---b     ->      a | b       becomes t = cad, other = dbc
//    \ /               \|/
//     d                 d
void Triangulation::flip(int t, int e) {
    const int other = faces_[t].neighbors[e];
    const int f = mirrorEdge(t, e);
    const Face top = faces_[t];
    const Face bottom = faces_[other];
    const int a = top.corners[e];
    const int b = top.corners[nextCorner(e)];
    const int c = top.corners[previousCorner(e)];
    const int d = bottom.corners[previousCorner(f)];
    const int bc = nextCorner(e), ca = previousCorner(e);
    const int ad = nextCorner(f), db = previousCorner(f);
    faces_[t].corners = {c, a, d};
    faces_[t].neighbors = {top.neighbors[ca], bottom.neighbors[ad], other};
    faces_[t].constrained = {top.constrained[ca], bottom.constrained[ad], false};
    faces_[other].corners = {d, b, c};
    faces_[other].neighbors = {bottom.neighbors[db], top.neighbors[bc], t};
    faces_[other].constrained = {bottom.constrained[db], top.constrained[bc], false};
    linkNeighbor(bottom.neighbors[ad], a, d, t);
    linkNeighbor(top.neighbors[bc], b, c, other);
    remember(t);
    remember(other);
}

bool Triangulation::shouldFlip(int t, int e) const {
    if (faces_[t].neighbors[e] < 0 || faces_[t].constrained[e]) {
        return false;
    }
    const Triangle& corners = faces_[t].corners;
    return inCircle(measured(corners[0]), measured(corners[1]), measured(corners[2]),
                    measured(oppositeVertex(t, e))) &&
           convex(t, e);
}

void Triangulation::legalize(std::initializer_list<std::array<int, 2>> pending) {
    pending_ = pending;
    for (int guard = 0; !pending_.empty() && guard < kMostFlips; ++guard) {
        const auto [t, v] = pending_.back();
        pending_.pop_back();
        const int corner = cornerOf(t, v);
        if (corner < 0 || !shouldFlip(t, nextCorner(corner))) {
            continue;
        }
        const int other = faces_[t].neighbors[nextCorner(corner)];
        flip(t, nextCorner(corner));
        pending_.push_back({t, v});
        pending_.push_back({other, v});
    }
}

bool Triangulation::holds(int t, const Vec2& p, Location& location) const {
    const Triangle& corners = faces_[t].corners;
    int zeros = 0;
    int zeroEdge = -1;
    for (int e = 0; e < 3; ++e) {
        const int side = orient2d(points_[corners[e]], points_[corners[nextCorner(e)]], p);
        if (side < 0) {
            return false;
        }
        if (side == 0) {
            ++zeros;
            zeroEdge = e;
        }
    }
    location = {zeros == 0 ? Where::inside : Where::onEdge, t, zeroEdge};
    for (int i = 0; i < 3; ++i) {
        if (points_[corners[i]] == p) {
            location = {Where::onVertex, t, i};
        }
    }
    return true;
}

int Triangulation::walkTowards(const Vec2& p) const {
    int t = lastFace_ < size() ? lastFace_ : 0;
    int previous = -1;
    for (int step = 0; step < kMostWalkSteps; ++step) {
        int next = -1;
        for (int i = 0; i < 3 && next < 0; ++i) {
            const int e = (i + step) % 3;  // rotate the first edge, so that no cycle can trap it
            const int beyond = faces_[t].neighbors[e];
            const bool cameFrom = previous >= 0 && beyond == previous;
            if (!cameFrom && beyond >= 0 &&
                orient2d(points_[faces_[t].corners[e]], points_[faces_[t].corners[nextCorner(e)]],
                         p) < 0) {
                next = beyond;
            }
        }
        if (next < 0) {
            return t;
        }
        previous = t;
        t = next;
    }
    return t;
}

Triangulation::Location Triangulation::locate(const Vec2& p) {
    Location location;
    if (holds(walkTowards(p), p, location)) {
        lastFace_ = location.triangle;
        return location;
    }
    for (int t = 0; t < size(); ++t) {
        if (holds(t, p, location)) {
            lastFace_ = t;
            return location;
        }
    }
    return {};
}

Triangulation::Insertion Triangulation::insert(const Vec2& p) {
    return insert(p, locate(p));
}

Triangulation::Insertion Triangulation::insert(const Vec2& p, const Location& location) {
    if (location.where == Where::outside) {
        return {};
    }
    if (location.where == Where::onVertex) {
        return {faces_[location.triangle].corners[location.index], true};
    }
    const int v = static_cast<int>(points_.size());
    points_.push_back(p);
    faceOfVertex_.push_back(location.triangle);
    if (location.where == Where::inside) {
        splitFace(location.triangle, v);
    } else if (faces_[location.triangle].neighbors[location.index] < 0) {
        splitBorderEdge(location.triangle, location.index, v);
    } else {
        splitEdge(location.triangle, location.index, v);
    }
    return {v, false};
}

void Triangulation::splitFace(int t, int v) {
    const Face old = faces_[t];
    const auto [a, b, c] = old.corners;
    const int t1 = size();
    const int t2 = t1 + 1;
    faces_[t] = {
        {a, b, v}, {old.neighbors[0], t1, t2}, {old.constrained[0], false, false}, old.marked};
    faces_.push_back(
        {{b, c, v}, {old.neighbors[1], t2, t}, {old.constrained[1], false, false}, old.marked});
    faces_.push_back(
        {{c, a, v}, {old.neighbors[2], t, t1}, {old.constrained[2], false, false}, old.marked});
    linkNeighbor(old.neighbors[1], b, c, t1);
    linkNeighbor(old.neighbors[2], c, a, t2);
    remember(t);
    remember(t1);
    remember(t2);
    legalize({{t, v}, {t1, v}, {t2, v}});
}

void Triangulation::splitBorderEdge(int t, int e, int v) {
    const Face old = faces_[t];
    const int a = old.corners[e], b = old.corners[nextCorner(e)],
              c = old.corners[previousCorner(e)];
    const int bc = nextCorner(e), ca = previousCorner(e);
    const int t1 = size();
    faces_[t] = {{v, c, a},
                 {t1, old.neighbors[ca], -1},
                 {false, old.constrained[ca], old.constrained[e]},
                 old.marked};
    faces_.push_back({{v, b, c},
                      {-1, old.neighbors[bc], t},
                      {old.constrained[e], old.constrained[bc], false},
                      old.marked});
    linkNeighbor(old.neighbors[bc], b, c, t1);
    remember(t);
    remember(t1);
    legalize({{t, v}, {t1, v}});
}

//     c                 c
//    / \               /|\        t = abc, other = bad with v on ab become
//   a-v-b     ->      a-v-b       t = vca, t1 = vbc, other = vad, t2 = vdb
//    \ /               \|/
//     d                 d
void Triangulation::splitEdge(int t, int e, int v) {
    const int other = faces_[t].neighbors[e];
    const int f = mirrorEdge(t, e);
    const Face top = faces_[t];
    const Face bottom = faces_[other];
    const int a = top.corners[e], b = top.corners[nextCorner(e)],
              c = top.corners[previousCorner(e)];
    const int d = bottom.corners[previousCorner(f)];
    const int bc = nextCorner(e), ca = previousCorner(e);
    const int ad = nextCorner(f), db = previousCorner(f);
    const bool held = top.constrained[e];
    const int t1 = size();
    const int t2 = t1 + 1;
    faces_[t] = {
        {v, c, a}, {t1, top.neighbors[ca], other}, {false, top.constrained[ca], held}, top.marked};
    faces_.push_back(
        {{v, b, c}, {t2, top.neighbors[bc], t}, {held, top.constrained[bc], false}, top.marked});
    faces_[other] = {{v, a, d},
                     {t, bottom.neighbors[ad], t2},
                     {held, bottom.constrained[ad], false},
                     bottom.marked};
    faces_.push_back({{v, d, b},
                      {other, bottom.neighbors[db], t1},
                      {false, bottom.constrained[db], held},
                      bottom.marked});
    linkNeighbor(top.neighbors[bc], b, c, t1);
    linkNeighbor(bottom.neighbors[db], d, b, t2);
    for (const int changed : {t, t1, other, t2}) {
        remember(changed);
    }
    legalize({{t, v}, {t1, v}, {other, v}, {t2, v}});
}

template <class Visit>
void Triangulation::visitStar(int v, Visit&& visit) const {
    const int first = faceOfVertex_[v];
    int t = first;
    do {  // counter-clockwise, up to the border or round
        const int corner = cornerOf(t, v);
        if (visit(t, corner)) {
            return;
        }
        t = faces_[t].neighbors[previousCorner(corner)];
    } while (t >= 0 && t != first);
    if (t == first) {
        return;
    }
    for (t = faces_[first].neighbors[cornerOf(first, v)]; t >= 0;) {  // the rest, clockwise
        const int corner = cornerOf(t, v);
        if (visit(t, corner)) {
            return;
        }
        t = faces_[t].neighbors[corner];
    }
}

Triangulation::EdgeRef Triangulation::findEdge(int a, int b) const {
    EdgeRef found;
    visitStar(a, [&](int t, int corner) {
        if (faces_[t].corners[nextCorner(corner)] == b) {
            found = {t, corner};
        } else if (faces_[t].corners[previousCorner(corner)] == b) {
            found = {t, previousCorner(corner)};
        }
        return found.found();
    });
    return found;
}

void Triangulation::markConstrained(const EdgeRef& edge) {
    faces_[edge.triangle].constrained[edge.edge] = true;
    const int other = faces_[edge.triangle].neighbors[edge.edge];
    if (other >= 0) {
        faces_[other].constrained[mirrorEdge(edge.triangle, edge.edge)] = true;
    }
}

// The edge opposite to a through which the segment ab leaves the star of a. Nothing where the
// segment runs over a vertex.
Triangulation::EdgeRef Triangulation::firstCrossed(int a, int b) const {
    const Vec2& from = points_[a];
    const Vec2& to = points_[b];
    EdgeRef crossed;
    visitStar(a, [&](int t, int corner) {
        const int right = faces_[t].corners[nextCorner(corner)];
        const int left = faces_[t].corners[previousCorner(corner)];
        const int sideRight = orient2d(from, to, points_[right]);
        const int sideLeft = orient2d(from, to, points_[left]);
        if ((sideRight == 0 && (points_[right] - from).dot(to - from) > 0) ||
            (sideLeft == 0 && (points_[left] - from).dot(to - from) > 0)) {
            return true;
        }
        if (sideRight < 0 && sideLeft > 0) {
            crossed = {t, nextCorner(corner)};
        }
        return crossed.found();
    });
    return crossed;
}

bool Triangulation::collectCrossed(int a, int b, std::vector<std::array<int, 2>>& crossed) const {
    EdgeRef at = firstCrossed(a, b);
    while (at.found()) {
        const Face& face = faces_[at.triangle];
        const int other = face.neighbors[at.edge];
        if (face.constrained[at.edge] || other < 0) {
            return false;
        }
        crossed.push_back({face.corners[at.edge], face.corners[nextCorner(at.edge)]});
        const int f = mirrorEdge(at.triangle, at.edge);
        const int d = faces_[other].corners[previousCorner(f)];
        if (d == b) {
            return true;
        }
        const int side = orient2d(points_[a], points_[b], points_[d]);
        if (side == 0) {
            return false;
        }
        at = {other, side > 0 ? nextCorner(f) : previousCorner(f)};
    }
    return false;
}

// Flips crossed edges until none crosses ab any more (Sloan 1993).
bool Triangulation::flipAway(int a, int b, std::vector<std::array<int, 2>> crossed,
                             std::vector<std::array<int, 2>>& created) {
    for (std::size_t i = 0; i < crossed.size(); ++i) {
        if (i > static_cast<std::size_t>(kMostConstraintFlips)) {
            return false;
        }
        const EdgeRef edge = findEdge(crossed[i][0], crossed[i][1]);
        if (!edge.found()) {
            return false;
        }
        if (!convex(edge.triangle, edge.edge)) {
            crossed.push_back(crossed[i]);
            continue;
        }
        const int c = faces_[edge.triangle].corners[previousCorner(edge.edge)];
        const int d = oppositeVertex(edge.triangle, edge.edge);
        flip(edge.triangle, edge.edge);
        const bool touchesEnd = c == a || c == b || d == a || d == b;
        if (!touchesEnd && orient2d(points_[a], points_[b], points_[c]) *
                                   orient2d(points_[a], points_[b], points_[d]) <
                               0) {
            crossed.push_back({c, d});
        } else {
            created.push_back({c, d});
        }
    }
    return true;
}

void Triangulation::restoreDelaunay(std::vector<std::array<int, 2>>& edges) {
    bool changed = true;
    for (int round = 0; round < 3 && changed; ++round) {
        changed = false;
        for (auto& ends : edges) {
            const EdgeRef edge = findEdge(ends[0], ends[1]);
            if (!edge.found() || !shouldFlip(edge.triangle, edge.edge)) {
                continue;
            }
            ends = {faces_[edge.triangle].corners[previousCorner(edge.edge)],
                    oppositeVertex(edge.triangle, edge.edge)};
            flip(edge.triangle, edge.edge);
            changed = true;
        }
    }
}

bool Triangulation::constrain(int a, int b) {
    if (a == b) {
        return false;
    }
    EdgeRef edge = findEdge(a, b);
    if (!edge.found()) {
        std::vector<std::array<int, 2>> crossed;
        std::vector<std::array<int, 2>> created;
        if (!collectCrossed(a, b, crossed) || !flipAway(a, b, crossed, created)) {
            return false;
        }
        edge = findEdge(a, b);
        if (!edge.found()) {
            return false;
        }
        markConstrained(edge);
        restoreDelaunay(created);
        return true;
    }
    markConstrained(edge);
    return true;
}

}  // namespace kerf::cut
