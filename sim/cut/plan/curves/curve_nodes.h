#pragma once

#include <vector>

#include "sim/cut/plan/curves/cut_curves.h"
#include "sim/cut/plan/curves/triangle_pair.h"
#include "sim/cut/plan/input/predicate_positions.h"
#include "sim/cut/plan/strip/strip.h"

namespace kerf::cut {

/// Makes the nodes of the intersection curves of a step's strip and the mesh, each once.
class CurveNodes {
  public:
    /// All must outlive the object.
    CurveNodes(const StepInput& in, const Strip& strip, const PredicatePositions& positions);

    /// The E node of a mesh edge of the pair, which crosses the strip triangle.
    int onEdge(const TrianglePair& pair, const Crossing& crossing);
    /// The F node of the strip edge `edge` of the pair, which crosses the mesh triangle in slot m.
    int onFace(const TrianglePair& pair, int m, int edge, const Crossing& crossing);
    /// The V node of the vertex that the pair shares.
    int atSharedVertex(const TrianglePair& pair);
    /// Adds a curve segment between two nodes, in the mesh triangle in slot m.
    void join(int m, int stripTriangle, int from, int to);

    /// The curves, with nodes ordered along edges and with positions.
    CutCurves take();

  private:
    int add(const CutNode& node);
    double parameterOf(int from, int to, double t) const;
    Vec3 weightsInStrip(const TrianglePair& pair, const Crossing& crossing) const;
    void orderAlongEdge(std::vector<EdgeHit>& hits);
    void placeOnEdge(CutNode& node) const;
    void placeOnFace(CutNode& node) const;

    const SurfaceMesh& mesh_;
    const Strip& strip_;
    const PredicatePositions& positions_;
    CutCurves curves_;
};

}  // namespace kerf::cut
