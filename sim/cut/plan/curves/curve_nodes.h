#pragma once

#include "sim/cut/plan/curves/cut_curves.h"
#include "sim/cut/plan/input/predicate_positions.h"
#include "sim/cut/plan/strip/strip.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

/// The corners of a triangle as rows, the last one twice, for vector instructions.
using ThreePoints = Eigen::Matrix<double, 4, 3>;

/// A triangle of the mesh as the predicates see it.
struct SeenTriangle {
    /// Takes the corners where they are seen.
    SeenTriangle(const Triangle& vertices, const Corners& corners);
    /// Puts the corners in canonical order.
    void putInOrder();
    /// The corners in canonical order.
    Corners inOrder() const { return {at[order[0]], at[order[1]], at[order[2]]}; }

    Triangle ids;
    Corners at;
    ThreePoints points;
    Vec3 sum;  ///< of the three
    /// Corner numbers in canonical order, and whether that order reverses the orientation; only
    /// once they are `ordered`.
    std::array<int, 3> order{0, 1, 2};
    int parity = 1;
    bool ordered = false;
};

/// A triangle of the strip.
struct StripTriangle {
    /// `which`: its place in the strip.
    StripTriangle(int which, const Triangle& nodes, const Corners& corners);

    int index;
    Triangle ids;  ///< nodes
    Corners at;
    ThreePoints points;
    Vec3 sum;
    double reach;  ///< largest coordinate
};

/// The vertex that the two triangles of a pair share.
struct SharedVertex {
    int count = 0;  ///< how many they share; the rest describes the last one
    int vertex = -1;
    int meshCorner = -1;
    int stripCorner = -1;

    bool any() const { return count > 0; }
    /// Whether the edge from this corner of the mesh triangle on ends in the vertex.
    bool isOnMeshEdge(int corner) const { return any() && isAt(corner, meshCorner); }
    /// Whether the edge from this corner of the strip triangle on ends in the vertex.
    bool isOnStripEdge(int corner) const { return any() && isAt(corner, stripCorner); }

  private:
    static bool isAt(int edge, int corner) { return edge == corner || (edge + 1) % 3 == corner; }
};

/// A mesh triangle, its corners in canonical order, and a triangle of the strip.
struct TrianglePair {
    const SeenTriangle& mesh;
    const StripTriangle& strip;
    SharedVertex shared;
};

/// Whether a cheap test finds a plane that separates the two, apart from a shared vertex.
bool areApart(const TrianglePair& pair);

/// The sides of the corners of each triangle of a pair against the plane of the other.
struct PairSigns {
    std::array<int, 3> mesh;   ///< by corner
    std::array<int, 3> strip;  ///< by corner, against the corners in canonical order
};
/// The signs of a pair; nothing where one triangle lies on one side of the other.
std::optional<PairSigns> signsOf(const TrianglePair& pair);

/// Where an edge of one triangle pierces the other.
struct Crossing {
    int from = 0;  ///< corner at which the edge starts, as both triangles beside it see it
    int to = 0;    ///< corner at which it ends
    /// Whether the curve in which the triangles meet, with the inside of the body on its left in
    /// the strip, ends here; otherwise it starts.
    bool isExit = false;
    double t = 0;                 ///< parameter along the edge
    Vec3 weights = Vec3::Zero();  ///< of the other triangle's corners, in the order of the signs
};
/// The crossing of the mesh triangle's edge from `corner` on; nothing if it misses the strip's.
/// Throws StepFailure if that is undecidable.
std::optional<Crossing> meshEdgeCrossing(const TrianglePair& pair, const PairSigns& signs,
                                         int corner);
/// The crossing of the strip triangle's edge from `corner` on, in the same way.
std::optional<Crossing> stripEdgeCrossing(const TrianglePair& pair, const PairSigns& signs,
                                          int corner);

/// The weights of abc where the line pq meets its plane.
Vec3 weightsOfCrossing(const Vec3& p, const Vec3& q, const Corners& abc);

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
