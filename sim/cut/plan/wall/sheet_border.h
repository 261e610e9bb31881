#pragma once

#include "sim/cut/exact/directed_edges.h"
#include "sim/cut/exact/triangulation.h"
#include "sim/cut/plan/wall/loops.h"

namespace kerf::cut {

/// A box in the layout plane [m].
struct Layout2d {
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = Vec2::Constant(-1e300);
};

/// One sheet as a constrained Delaunay triangulation in the layout plane, and the inner nodes that
/// it gets. Triangles inside of its border are marked.
class BorderedSheet {
  public:
    /// Takes the sheet without inner nodes, whose numbers will begin with `firstInner`. `nodes`
    /// must outlive the object; within a share of `h` [m] they coincide. Throws StepFailure if the
    /// border is invalid.
    BorderedSheet(const Sheet2d& sheet, const std::vector<CutNode>& nodes, int firstInner,
                  double h);

    /// The triangulation in the layout plane.
    Triangulation& plane() { return plane_; }
    /// The edges of the border.
    const std::vector<OutlineEdge>& border() const { return edges_; }
    /// The box of the border.
    const Layout2d& bounds() const { return bounds_; }
    /// The vertex of the triangulation at a node of the border.
    int vertexOf(int node) const { return vertexOfNode_[node]; }
    /// The node at a vertex of the triangulation, null for an inner one.
    const CutNode* borderNode(int vertex) const;
    /// Inserts a node inside; `at` is the result of locate(layout) just before.
    void addInner(const Vec2& layout, const Vec3& position, const Triangulation::Location& at);
    /// The inner nodes.
    const std::vector<CutNode>& inner() const { return inner_; }
    /// The nodes of a triangle inside.
    Triangle nodesOf(int t) const {
        return {nodeOfCorner(t, 0), nodeOfCorner(t, 1), nodeOfCorner(t, 2)};
    }
    /// The triangles inside, by nodes.
    std::vector<Triangle> triangles() const;

  private:
    void insertBorder(double coincident);
    std::vector<int> nodesAlongBlade() const;
    int cornerNear(int t, const Vec2& p, double distance) const;
    void constrainBorder();
    bool isBorder(int t, int e) const;
    void markInside();
    void spreadMark(int t, int e, std::vector<int>& pending);
    int nodeOfCorner(int t, int corner) const;

    const std::vector<CutNode>& nodes_;
    std::vector<OutlineEdge> edges_;
    Layout2d bounds_;
    int firstInner_;
    std::vector<CutNode> inner_;
    std::vector<int> vertexOfNode_;  ///< -1 for nodes of other sheets
    std::vector<int> nodeOfVertex_;  ///< -1 for the three enclosing ones; the border's come next
    int borderVertices_ = 0;         ///< vertices from here on are inner points
    DirectedEdges border_{0};        ///< places in edges_ by vertices
    std::vector<int> edgesFrom_;     ///< how many border edges start at each vertex
    Triangulation plane_;
};

}  // namespace kerf::cut
