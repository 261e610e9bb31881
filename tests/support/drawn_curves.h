#pragma once

#include "sim/cut/plan/curves/cut_curves.h"

namespace kerf::test {

/// Curves of a cut drawn by hand on a mesh, as intersect would give them. `strip`: the number of
/// the strip's triangle or edge that is said to meet the mesh there.
class DrawnCurves {
  public:
    explicit DrawnCurves(const SurfaceMesh& mesh) : mesh_(mesh) {}

    cut::CutCurves curves;

    /// A node at u + t (v - u) on an edge of the mesh; both triangles there are to be divided.
    int onEdge(int u, int v, double t, int strip);
    /// A node in a triangle, which is to be divided. `weights`: barycentric.
    int inFace(int triangle, const Vec3& weights, int strip);
    /// The node of a vertex.
    int atVertex(int v);
    /// A segment between two nodes in a triangle.
    void segment(int triangle, int from, int to, int strip);

  private:
    int add(cut::CutNode node, const Triangle& corners, const Vec3& weights);

    const SurfaceMesh& mesh_;
};

}  // namespace kerf::test
