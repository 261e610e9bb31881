#include "app/import/polygon_triangles.h"

#include "sim/base/containers.h"
#include "sim/cut/exact/triangulation.h"

namespace kerf::app {

namespace {

/// Twice the area of a polygon, as a vector along its normal (Newell).
Vec3 areaVector(const std::vector<Vec3>& corners) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& next = corners[(i + 1) % corners.size()];
        sum += (corners[i] - corners[0]).cross(next - corners[0]);
    }
    return sum;
}

/// The polygon seen along the axis that its normal is closest to: what lies in one line does so
/// exactly then. It runs counter-clockwise.
std::vector<Vec2> seenAlongAxis(const std::vector<Vec3>& corners, const Vec3& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const int right = normal[axis] > 0 ? (axis + 1) % 3 : (axis + 2) % 3;
    const int up = 3 - axis - right;
    return mapped(corners, [&](const Vec3& p) { return Vec2(p[right], p[up]); });
}

/// The polygon seen against its normal: a bent one shows most of itself.
std::vector<Vec2> seenAgainstNormal(const std::vector<Vec3>& corners, const Vec3& normal) {
    const Vec3 right = normal.unitOrthogonal();
    const Vec3 up = normal.stableNormalized().cross(right);
    return mapped(corners, [&](const Vec3& p) {
        return Vec2((p - corners[0]).dot(right), (p - corners[0]).dot(up));
    });
}

/// Whether corners at different places lie on each other in the picture.
bool hidesCorners(const std::vector<Vec3>& corners, const std::vector<Vec2>& points) {
    std::map<std::pair<double, double>, Vec3> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [place, isNew] = places.try_emplace({points[i].x(), points[i].y()}, corners[i]);
        if (!isNew && place->second != corners[i]) {
            return true;
        }
    }
    return false;
}

/// A triangle that lies around all points with room.
cut::Triangulation frameAround(const std::vector<Vec2>& points) {
    Eigen::AlignedBox2d box;
    for (const Vec2& p : points) {
        box.extend(p);
    }
    const double size = 4 * box.sizes().maxCoeff();
    const Vec2 middle = box.center();
    cut::Triangulation frame(middle + Vec2(-2 * size, -size), middle + Vec2(2 * size, -size),
                             middle + Vec2(0, 2 * size));
    frame.reserve(points.size());
    return frame;
}

/// A triangulation of a polygon's corners with its edges in it.
class PolygonTriangulation {
  public:
    explicit PolygonTriangulation(const std::vector<Vec2>& points)
        : plane_(frameAround(points)), cornerOf_(kFrame, -1) {
        for (int i = 0; i < static_cast<int>(points.size()); ++i) {
            const auto [vertex, existed] = plane_.insert(points[i]);
            if (!existed) {
                cornerOf_.push_back(i);
            }
            vertices_.push_back(vertex);
        }
    }

    /// The triangles inside, or nothing where edges cross.
    std::vector<Triangle> inside() {
        const bool clear = constrainEdges();
        const std::vector<int> windings = clear ? findWindings() : std::vector<int>{};
        std::vector<Triangle> triangles;
        for (std::size_t t = 0; t < windings.size(); ++t) {
            if (windings[t] != 0 && windings[t] != 1) {
                return {};
            }
            if (windings[t] == 1) {
                const auto& [a, b, c] = plane_.corners(static_cast<int>(t));
                triangles.push_back({cornerOf_[a], cornerOf_[b], cornerOf_[c]});
            }
        }
        return triangles;
    }

  private:
    static constexpr int kFrame = 3;  // the vertices around

    bool constrainEdges() {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const int from = vertices_[i];
            const int to = vertices_[(i + 1) % vertices_.size()];
            if (from == to) {
                continue;
            }
            if (from < 0 || to < 0 || !plane_.constrain(from, to)) {
                return false;
            }
            ++passes_[{from, to}];
            --passes_[{to, from}];
        }
        return true;
    }

    int passes(int from, int to) const {
        const auto found = passes_.find({from, to});
        return found == passes_.end() ? 0 : found->second;
    }

    /// How often the polygon runs around each triangle, from one at the frame on.
    std::vector<int> findWindings() const {
        std::vector<int> windings(plane_.size(), 0);
        std::vector<char> seen(plane_.size(), 0);
        std::vector<int> pending;
        const auto visit = [&](int t, int winding) {
            if (t >= 0 && seen[t] == 0) {
                seen[t] = 1;
                windings[t] = winding;
                pending.push_back(t);
            }
        };
        for (int t = 0; t < plane_.size() && pending.empty(); ++t) {
            const Triangle& corners = plane_.corners(t);
            visit(corners[0] < kFrame || corners[1] < kFrame || corners[2] < kFrame ? t : -1, 0);
        }
        while (!pending.empty()) {
            const int t = pending.back();
            pending.pop_back();
            for (int e = 0; e < 3; ++e) {
                const Triangle& corners = plane_.corners(t);
                visit(plane_.neighbor(t, e),
                      windings[t] - passes(corners[e], corners[(e + 1) % 3]));
            }
        }
        return windings;
    }

    cut::Triangulation plane_;
    std::vector<int> cornerOf_;                  ///< by vertex
    std::vector<int> vertices_;                  ///< by corner
    std::map<std::pair<int, int>, int> passes_;  ///< how often the polygon runs along, less back
};

}  // namespace

std::vector<Triangle> triangulatePolygon(const std::vector<Vec3>& corners) {
    const Vec3 normal = areaVector(corners);
    if (!normal.allFinite() || normal.isZero(0)) {
        return {};
    }
    for (const auto& points :
         {seenAlongAxis(corners, normal), seenAgainstNormal(corners, normal)}) {
        if (!hidesCorners(corners, points)) {
            std::vector<Triangle> triangles = PolygonTriangulation(points).inside();
            if (!triangles.empty()) {
                return triangles;
            }
        }
    }
    return {};
}

}  // namespace kerf::app
