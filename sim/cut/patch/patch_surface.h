#pragma once

#include <initializer_list>

#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// A point of a patch: on the rim of the wound, or at the mean of others.
struct PatchNode {
    std::vector<int> from;       ///< earlier nodes that it is the mean of; none on the rim
    Vec3 rest = Vec3::Zero();    ///< [m]
    Vec2 layout = Vec2::Zero();  ///< place in the plane of the wound [m]
    double size = 0;             ///< edge length wanted there [m]
};

/// The triangles of a patch while it is refined, with half-edges as those of SurfaceMesh;
/// half-edges along the rim have no twin (-1).
class PatchSurface {
  public:
    /// Links the triangles. Throws StepFailure where an edge is used twice in one direction.
    PatchSurface(std::vector<PatchNode> nodes, std::vector<Triangle> triangles);

    /// All nodes, those on the rim first.
    const std::vector<PatchNode>& nodes() const { return nodes_; }
    /// All triangles, by nodes.
    const std::vector<Triangle>& triangles() const { return triangles_; }
    /// The other half-edge of h's edge, -1 along the rim.
    int twin(int h) const { return twins_[h / 3][h % 3]; }
    /// The node at which h starts.
    int origin(int h) const { return triangles_[h / 3][h % 3]; }
    /// The node at which h ends.
    int target(int h) const { return triangles_[h / 3][(h % 3 + 1) % 3]; }
    /// The node opposite to h in its triangle.
    int apex(int h) const { return triangles_[h / 3][(h % 3 + 2) % 3]; }
    /// Whether the node lies on the rim of the wound.
    bool onRim(int node) const { return nodes_[node].from.empty(); }

    /// Twice the area of a triangle of nodes in the layout [m^2], positive where the patch is not
    /// folded over.
    double doubleArea(int a, int b, int c) const;

    /// Inserts a node in the middle of a triangle.
    void splitTriangle(int t);
    /// Inserts a node in the middle of an edge that is not on the rim.
    void splitEdge(int h);
    /// Flips edges that are not Delaunay in the layout, around what was divided since the last
    /// call.
    void relax();

  private:
    void link(int h, int g);
    int meanOf(std::vector<int> nodes);
    int addTriangle(const Triangle& corners);
    bool shouldTurn(int h) const;
    void mark(std::initializer_list<int> triangles);
    void turn(int h);

    std::vector<PatchNode> nodes_;
    std::vector<Triangle> triangles_;
    std::vector<std::array<int, 3>> twins_;
    std::set<Edge> edges_;
    std::vector<int> unrelaxed_;  ///< half-edges that may have to be flipped
};

}  // namespace kerf::cut
