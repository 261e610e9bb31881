#include "app/import/repair/near_borders.h"

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/mesh/box_tree.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/soup_editing.h"

namespace kerf::app {

namespace {

using repair::Side;

constexpr double kNear = 1e-5;  // of the diagonal

std::vector<int> verticesOf(const std::vector<Side>& sides) {
    std::vector<int> vertices;
    for (const Side& side : sides) {
        vertices.push_back(side.low);
        vertices.push_back(side.high);
    }
    sortUnique(vertices);
    return vertices;
}

/// Vertices by place.
class Vertices {
  public:
    Vertices(const TriangleSoup& soup, const std::vector<int>& vertices)
        : boundsOf_([&soup](int v) {
              return Bounds{soup.positions[v], soup.positions[v]};
          }),
          tree_(vertices, boundsOf_) {}

    /// Ascending; may hold more than those in the box.
    std::vector<int> in(const Bounds& box) {
        std::vector<int> found;
        tree_.find(
            boundsOf_, [&](const Bounds& b) { return b.overlaps(box); },
            [&](int v) { found.push_back(v); });
        std::ranges::sort(found);
        return found;
    }

  private:
    BoxTree::BoundsOf boundsOf_;
    BoxTree tree_;
};

bool isEdge(const std::vector<std::pair<int, int>>& edges, int a, int b) {
    return std::ranges::binary_search(edges, std::pair(std::min(a, b), std::max(a, b)));
}

int joinVertices(TriangleSoup& soup, const std::vector<Side>& open, double near) {
    const std::vector<int> vertices = verticesOf(open);
    auto edges = mapped(open, [](const Side& side) { return std::pair(side.low, side.high); });
    std::ranges::sort(edges);
    Vertices places(soup, verticesOf(repair::sidesByEdge(soup.triangles)));
    UnionFind sets(soup.positions.size());
    for (const int v : vertices) {
        const Vec3& at = soup.positions[v];
        for (const int other : places.in(widened(Bounds{at, at}, near))) {
            const double distance = (soup.positions[other] - at).norm();
            if (other != v && distance <= near && !isEdge(edges, v, other)) {
                sets.join(v, other);
            }
        }
    }
    int joined = 0;
    for (int v = 0; v < static_cast<int>(soup.positions.size()); ++v) {
        joined += sets.root(v) != v ? 1 : 0;
    }
    for (Triangle& t : soup.triangles) {
        for (int& v : t) {
            v = sets.root(v);
        }
    }
    repair::keepTriangles(soup, [&](int t) { return !repair::repeatsCorner(soup.triangles[t]); });
    return joined;
}

/// Vertices on an open edge, in the order in which it runs.
std::vector<int> verticesOn(const TriangleSoup& soup, int from, int to, Vertices& places,
                            double near) {
    const Vec3& a = soup.positions[from];
    const Vec3& b = soup.positions[to];
    std::vector<std::pair<double, int>> found;
    for (const int v : places.in(widened(boxOf({a, b}), near))) {
        const Vec3& at = soup.positions[v];
        const double way = (at - a).dot(b - a) / (b - a).squaredNorm();
        if (v != from && v != to && way > 0 && way < 1 && distanceToSegment(at, a, b) <= near &&
            (at - a).norm() > near && (at - b).norm() > near) {
            found.emplace_back(way, v);
        }
    }
    std::ranges::sort(found);
    return mapped(found, [](const auto& each) { return each.second; });
}

/// Divides a triangle into a fan from the corner across.
void divide(TriangleSoup& soup, int halfEdge, const std::vector<int>& on) {
    const int t = halfEdge / 3;
    const Triangle corners = soup.triangles[t];
    const TriangleAttributes attributes = attributesOf(soup.skin, t);
    const int corner = halfEdge % 3;
    const int from = corners[corner];
    const int apex = corners[(corner + 2) % 3];
    std::vector<int> way = on;
    way.push_back(corners[(corner + 1) % 3]);
    soup.triangles[t] = {from, way[0], apex};
    for (std::size_t i = 1; i < way.size(); ++i) {
        repair::addTriangle(soup, {way[i - 1], way[i], apex}, attributes);
    }
}

int divideEdges(TriangleSoup& soup, double near) {
    const std::vector<Side> open = repair::openSides(soup);
    Vertices places(soup, verticesOf(open));
    std::vector<char> done(soup.triangles.size(), 0);
    int divided = 0;
    for (const Side& side : open) {
        const int from = side.upward ? side.low : side.high;
        const int to = side.upward ? side.high : side.low;
        const std::vector<int> on = verticesOn(soup, from, to, places, near);
        const Triangle corners = soup.triangles[side.triangle()];
        const bool ownCorner = std::ranges::any_of(
            on, [&](int v) { return std::ranges::find(corners, v) != corners.end(); });
        if (!on.empty() && !ownCorner && std::exchange(done[side.triangle()], 1) == 0) {
            divide(soup, side.halfEdge, on);
            ++divided;
        }
    }
    return divided;
}

}  // namespace

JoinedBorders joinNearBorders(TriangleSoup& soup) {
    JoinedBorders joined;
    const std::vector<Side> open = repair::openSides(soup);
    if (open.empty()) {
        return joined;
    }
    const auto boxOfTriangle = [&](const Triangle& t) {
        return boxOf(t, [&](int v) { return soup.positions[v]; });
    };
    const double near = kNear * boxOf(soup.triangles, boxOfTriangle).diagonal();
    joined.vertices = joinVertices(soup, open, near);
    joined.edges = divideEdges(soup, near);
    return joined;
}

}  // namespace kerf::app
