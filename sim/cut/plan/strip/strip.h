#pragma once

#include "sim/base/math.h"
#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

/// Twice the signed area between two vectors in the layout plane.
inline double cross2(const Vec2& u, const Vec2& v) {
    return u.x() * v.y() - u.y() * v.x();
}

/// A corner of the strip. Layout coordinates: x = s |AB|, the old rung at y = 0.
struct StripNode {
    Vec3 position = Vec3::Zero();  ///< [m]
    Vec2 layout = Vec2::Zero();    ///< [m]
    double s = 0;                  ///< parameter along the blade
    /// The mesh vertices that the node stands for: none in the air, several where the front crosses
    /// an older slit or where front vertices coincide.
    std::vector<int> vertices;
    /// Whether each of them is joined to the next by a front edge (of length zero).
    std::vector<char> attachedWithin;
    /// Whether the edge to the next node of the old rung is a front edge of the mesh.
    bool attached = false;

    /// Whether a front edge joins the vertices i and i + 1 of the node.
    bool joinsNext(int i) const {
        return i >= 0 && i < sizeOf(attachedWithin) && attachedWithin[i] != 0;
    }
};

/// The lengths wanted for the edges of a new rung: those around at the ends of the front, where the
/// rim is, longer away from them (WallGrading), and no longer than the row of the wall is high.
class RungSpacing {
  public:
    /// As the edges around.
    RungSpacing() = default;
    /// `oldRung`: the nodes from which the step leads to the blade.
    RungSpacing(const StepInput& in, const std::vector<StripNode>& oldRung);
    /// The length wanted at parameter s of the blade, where edges are `edge` long [m].
    double at(double s, double edge) const;

  private:
    struct RowHeight {
        double s;
        double fromRim;  ///< distance along the front to its nearer end; 0 outside [m]
        double height;   ///< of the row [m]
    };
    std::vector<RowHeight> places_;  ///< nodes of the old rung; none where nothing grows
    WallGrading grading_;
};

/// An edge of the strip between the nodes a and b.
struct StripEdge {
    int a = -1;            ///< node
    int b = -1;            ///< node
    int frontOf = -1;      ///< the piece whose front edge it is, -1 where it is none
    bool onBorder = true;  ///< a triangle, which runs a -> b, lies on one side alone
};

/// The band that the blade has swept in one step, from the old rung R0 to the new one R1:
/// triangulated, counter-clockwise in the layout plane.
struct Strip {
    std::vector<StripNode> nodes;  ///< the old rung's first, then the new one's
    int oldCount = 0;              ///< number of nodes of the old rung
    std::vector<int> newRung;      ///< nodes of R1 from A to B; ends may be shared with R0 (pinned)
    RungSpacing spacing;           ///< lengths wanted along the new rung
    double height = 0;             ///< largest distance of the old rung to the new one's line [m]
    std::vector<Triangle> triangles;      ///< triples of nodes
    std::vector<Triangle> triangleEdges;  ///< edges of each triangle, e from corner e on
    std::vector<StripEdge> edges;         ///< each once

    /// Whether a node lies on the old rung.
    bool isOld(int node) const { return node < oldCount; }
    /// Whether a front edge joins an old node to the one before it.
    bool attachedBefore(int node) const { return node > 0 && nodes[node - 1].attached; }
    /// Whether the edge lies on R1; rails, which join the ends of R0 and R1, do not.
    bool onNewRung(int edge) const;
    /// The strip as one piece of the body sees it: without the vertices and fronts of others.
    Strip seenBy(int piece, const std::vector<int>& pieceOfVertex) const;

  private:
    bool isNew(int node) const;
    bool isRail(int edge) const;
};

/// Finds the points of a strip for places of the layout plane.
class StripLocator {
  public:
    /// The strip must outlive the object.
    StripLocator(const Blade& blade, const Strip& strip);
    /// The point of the strip there [m]. Throws StepFailure outside.
    Vec3 at(const Vec2& layout) const;

  private:
    const Strip& strip_;
    double room_;
    /// The triangles follow each other along the blade: for each, how far they have come.
    std::vector<double> reachOfTriangle_;
};

}  // namespace kerf::cut
