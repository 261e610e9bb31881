#pragma once

#include <map>
#include <vector>

#include "sim/cut/plan/step.h"

namespace kerf::cut {

/// Where the predicates see the mesh vertices. Real positions, except that mates may close, that
/// retraced slits open, and that vertices on a front node are seen exactly there. Nothing real
/// moves.
class PredicatePositions {
  public:
    explicit PredicatePositions(const StepInput& in);

    /// With the pins.
    Vec3 at(int v) const;
    /// Without the pins.
    Vec3 ofMaterial(int v) const;
    /// From now on v is seen at p.
    void pin(int v, const Vec3& p) { pins_[v] = p; }

  private:
    const SurfaceMesh& mesh_;
    const SlitOpening* opening_;  ///< null where there is none to see
    double closeDistance_;
    std::map<int, Vec3> pins_;
};

/// A corner of the strip. Layout coordinates: x = s |AB|, the old rung at y = 0.
struct StripNode {
    Vec3 position = Vec3::Zero();
    Vec2 layout = Vec2::Zero();
    double s = 0;
    /// Mesh vertices that the node stands for: none in the air, several where the front crosses
    /// an older slit or where front vertices coincide.
    std::vector<int> vertices;
    /// Between each of them and the next: whether they are joined by a front edge (of length zero).
    std::vector<char> attachedWithin;
    /// Vertices of other pieces that lie here (Attempt::touching).
    std::vector<int> touching;
    /// The edge to the next node of the old rung is a front edge of the mesh.
    bool attached = false;

    /// Several vertices, joined by front edges of length zero.
    bool isCluster() const;
    /// A front edge joins the vertices i and i + 1.
    bool joinsNext(int i) const {
        return i >= 0 && i < sizeOf(attachedWithin) && attachedWithin[i] != 0;
    }
};

/// An edge of the strip between the nodes a and b.
struct StripEdge {
    int a = -1;
    int b = -1;
    int first = -1;    ///< triangle that runs a -> b
    int second = -1;   ///< the other one, -1 on the border
    int frontOf = -1;  ///< the piece whose front edge it is, -1 where it is none
    bool onBorder() const { return second < 0; }
};

/// What the blade sweeps in one step: a triangulated band from the old rung R0 to the new one R1,
/// counter-clockwise in the layout plane.
struct Strip {
    std::vector<StripNode> nodes;  ///< the old rung first
    int oldCount = 0;
    std::vector<int> newRung;  ///< nodes of R1 from A to B; ends may be shared with R0 (pinned)
    double height = 0;         ///< largest distance of the old rung to the new one's line [m]
    std::vector<Triangle> triangles;
    std::vector<Triangle> triangleEdges;
    std::vector<StripEdge> edges;

    bool isOld(int node) const { return node < oldCount; }
    /// Front edges on either side of an old node.
    bool attachedBefore(int node) const { return node > 0 && nodes[node - 1].attached; }
    bool attachedAfter(int node) const { return isOld(node) && nodes[node].attached; }
    /// The edge lies on R1, rails excluded.
    bool onNewRung(int edge) const;
    /// The strip as one piece of the body sees it: without the vertices and fronts of others.
    Strip seenBy(int piece, const std::vector<int>& pieceOfVertex) const;

  private:
    bool isNew(int node) const;
    bool isRail(int edge) const;
};

/// The fixed displacement of the blade at parameter s, the same for a whole pass.
Vec3 bladeOffset(const StepInput& in, double s);
/// The same for an offset of `length` [m] at scale 1.
Vec3 bladeOffset(double length, double scale, std::uint64_t seed, int pass, double s);
/// The point of the blade at parameter s, without the offset.
Vec3 bladePoint(const StepInput& in, double s);

/// Joins old and new rung. The new one has no nodes at the parameters `skipped`.
/// Throws StepFailure.
Strip buildStrip(const StepInput& in, PredicatePositions& positions,
                 const std::vector<double>& skipped = {});

/// Triangles between two chains (node ids and their s), the first below. With a shared end the
/// other chain advances first, so that no triangle has three nodes on one rung.
std::vector<Triangle> zip(const std::vector<int>& lower, const std::vector<double>& lowerS,
                          const std::vector<int>& upper, const std::vector<double>& upperS);

}  // namespace kerf::cut
