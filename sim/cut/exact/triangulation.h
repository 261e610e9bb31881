#pragma once

#include <Eigen/Dense>
#include <initializer_list>

#include "sim/base/math.h"

namespace kerf::cut {

/// A small constrained Delaunay triangulation in the plane. Orientation is exact; the in-circle
/// test is not, since it only affects shape.
///
/// Edge e of a triangle runs from corner e to corner e + 1.
class Triangulation {
  public:
    /// Starts with the triangle abc (counter-clockwise); everything happens inside it.
    Triangulation(const Vec2& a, const Vec2& b, const Vec2& c);

    /// Makes room for `points` more points inside the triangle.
    void reserve(std::size_t points) {
        points_.reserve(points_.size() + points);
        faceOfVertex_.reserve(faceOfVertex_.size() + points);
        faces_.reserve(faces_.size() + 2 * points);
    }
    /// Applies the Delaunay criterion to metric * point from now on.
    void setMetric(const Eigen::Matrix2d& metric) {
        metric_ = metric;
        hasMetric_ = true;
    }

    /// The result of the insertion of a point.
    struct Insertion {
        int vertex = -1;       ///< its number, -1 for a point outside
        bool existed = false;  ///< a vertex already lies exactly there
    };
    /// Inserts a point and restores the Delaunay criterion around it.
    Insertion insert(const Vec2& p);
    /// Makes ab a constrained edge; false if that would cross another constraint or a vertex.
    bool constrain(int a, int b);

    /// The part of a triangle that a point is on; `outside` for none.
    enum class Where { outside, inside, onEdge, onVertex };
    /// The place of a point in the triangulation.
    struct Location {
        Where where = Where::outside;  ///< the part of `triangle`
        int triangle = -1;             ///< the closed triangle that holds the point
        int index = -1;                ///< edge or corner of the triangle
    };
    /// Finds the place of a point.
    Location locate(const Vec2& p);
    /// Inserts p like insert(p); `at` is the result of locate(p) just before.
    Insertion insert(const Vec2& p, const Location& at);

    /// The number of triangles.
    int size() const { return static_cast<int>(faces_.size()); }
    /// The position of vertex v.
    const Vec2& point(int v) const { return points_[v]; }
    /// The vertices of triangle t, counter-clockwise.
    const Triangle& corners(int t) const { return faces_[t].corners; }
    /// The triangle across edge e of t, -1 at the outer border.
    int neighbor(int t, int e) const { return faces_[t].neighbors[e]; }
    /// Whether edge e of t is a constraint.
    bool constrained(int t, int e) const { return faces_[t].constrained[e]; }
    /// The caller's mark of triangle t, handed down when it is divided. Constraints bound it.
    bool marked(int t) const { return faces_[t].marked; }
    /// Sets or clears the mark of triangle t.
    void setMarked(int t, bool on) { faces_[t].marked = on; }

    /// The edge of the neighbour across (t, e) that is the same edge.
    int mirrorEdge(int t, int e) const;
    /// The corner of the neighbour across (t, e) that is not on the edge.
    int oppositeVertex(int t, int e) const;
    /// Whether the two triangles at (t, e) form a strictly convex quadrilateral.
    bool convex(int t, int e) const;
    /// Replaces the edge by the other diagonal; the quadrilateral must be convex.
    void flip(int t, int e);

  private:
    struct Face {
        Triangle corners;
        Triangle neighbors;
        std::array<bool, 3> constrained{false, false, false};
        bool marked = false;
    };
    struct EdgeRef {
        int triangle = -1;
        int edge = -1;
        bool found() const { return triangle >= 0; }
    };

    bool holds(int t, const Vec2& p, Location& location) const;
    int walkTowards(const Vec2& p) const;
    void splitFace(int t, int v);
    void splitEdge(int t, int e, int v);
    void splitBorderEdge(int t, int e, int v);
    void linkNeighbor(int t, int from, int to, int neighbor);
    void remember(int t);
    bool shouldFlip(int t, int e) const;
    Vec2 measured(int v) const { return hasMetric_ ? Vec2(metric_ * points_[v]) : points_[v]; }
    void legalize(std::initializer_list<std::array<int, 2>> pending);
    int cornerOf(int t, int v) const;
    /// Calls visit(triangle, corner of v) around v until it answers true.
    template <class Visit>
    void visitStar(int v, Visit&& visit) const;
    EdgeRef findEdge(int a, int b) const;
    void markConstrained(const EdgeRef& edge);
    EdgeRef firstCrossed(int a, int b) const;
    bool collectCrossed(int a, int b, std::vector<std::array<int, 2>>& crossed) const;
    bool flipAway(int a, int b, std::vector<std::array<int, 2>> crossed,
                  std::vector<std::array<int, 2>>& created);
    void restoreDelaunay(std::vector<std::array<int, 2>>& edges);

    std::vector<Vec2> points_;
    std::vector<Face> faces_;
    std::vector<int> faceOfVertex_;
    int lastFace_ = 0;
    Eigen::Matrix2d metric_ = Eigen::Matrix2d::Identity();
    bool hasMetric_ = false;
    std::vector<std::array<int, 2>> pending_;  ///< room for legalize
};

}  // namespace kerf::cut
