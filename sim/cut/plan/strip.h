#pragma once

#include <map>
#include <vector>

#include "sim/cut/plan/step.h"

namespace kerf::cut {

/// The positions at which the predicates see the mesh vertices: the real ones, except that copies
/// may close, that retraced slits open, and that pinned vertices are seen where they are pinned, as
/// those of a front node exactly there. Nothing real moves.
class PredicatePositions {
  public:
    /// Sees the mesh as the step's attempt and opening want it, without pins.
    explicit PredicatePositions(const StepInput& in);

    /// The position of v, with the pins [m].
    Vec3 at(int v) const;
    /// The position of v, without the pins [m].
    Vec3 withoutPins(int v) const;
    /// Lets v be seen at p from now on.
    void pin(int v, const Vec3& p) { pins_[v] = p; }
    /// Lets v, which lies in the strip, be seen beside it from now on, by `way` [m].
    void pinAside(int v, const Vec3& way);
    /// Whether v is seen beside the strip in which it lies.
    bool isAside(int v) const { return asideFrom_.count(v) > 0; }
    /// The position of v, with the pins but for those aside [m].
    Vec3 inStrip(int v) const;
    /// The farthest that any vertex was pinned aside [m].
    double asideReach() const { return asideReach_; }

  private:
    const SurfaceMesh& mesh_;
    const SlitOpening* opening_;  ///< null where there is none to see
    double closeDistance_;
    std::map<int, Vec3> pins_;
    std::map<int, Vec3> asideFrom_;  ///< where vertices lie that are pinned aside
    double asideReach_ = 0;
};

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
    /// The vertices of other pieces that lie here (Attempt::touching).
    std::vector<int> touching;
    /// Whether the edge to the next node of the old rung is a front edge of the mesh.
    bool attached = false;

    /// Whether the node has several vertices, joined by front edges of length zero.
    bool isCluster() const;
    /// Whether a front edge joins the vertices i and i + 1 of the node.
    bool joinsNext(int i) const {
        return i >= 0 && i < sizeOf(attachedWithin) && attachedWithin[i] != 0;
    }
};

/// An edge of the strip between the nodes a and b.
struct StripEdge {
    int a = -1;        ///< node
    int b = -1;        ///< node
    int first = -1;    ///< triangle that runs a -> b
    int second = -1;   ///< triangle that runs b -> a, -1 on the border
    int frontOf = -1;  ///< the piece whose front edge it is, -1 where it is none
    /// Whether the edge has a triangle on one side alone.
    bool onBorder() const { return second < 0; }
};

/// The band that the blade has swept in one step, from the old rung R0 to the new one R1:
/// triangulated, counter-clockwise in the layout plane.
struct Strip {
    std::vector<StripNode> nodes;  ///< the old rung's first, then the new one's
    int oldCount = 0;              ///< number of nodes of the old rung
    std::vector<int> newRung;      ///< nodes of R1 from A to B; ends may be shared with R0 (pinned)
    double height = 0;             ///< largest distance of the old rung to the new one's line [m]
    std::vector<Triangle> triangles;      ///< triples of nodes
    std::vector<Triangle> triangleEdges;  ///< edges of each triangle, e from corner e on
    std::vector<StripEdge> edges;         ///< each once

    /// Whether a node lies on the old rung.
    bool isOld(int node) const { return node < oldCount; }
    /// Whether a front edge joins an old node to the one before it.
    bool attachedBefore(int node) const { return node > 0 && nodes[node - 1].attached; }
    /// Whether a front edge joins an old node to the one after it.
    bool attachedAfter(int node) const { return isOld(node) && nodes[node].attached; }
    /// Whether the edge lies on R1; rails, which join the ends of R0 and R1, do not.
    bool onNewRung(int edge) const;
    /// The strip as one piece of the body sees it: without the vertices and fronts of others.
    Strip seenBy(int piece, const std::vector<int>& pieceOfVertex) const;

  private:
    bool isNew(int node) const;
    bool isRail(int edge) const;
};

/// How far, as a share of h, a blade that stays in its plane is led aside: exact predicates need no
/// more, so that it meets nothing exactly.
inline constexpr double kLeastOffset = 1e-9;
/// The fixed displacement [m] of a blade at parameter s for an offset of `length` [m] at scale 1.
Vec3 bladeOffset(double length, double scale, std::uint64_t seed, int transit, double s);
/// The point of the blade at parameter s, without the offset [m].
Vec3 bladePoint(const StepInput& in, double s);

/// Builds the strip of a step between the old rung and a new one, which has no nodes at the
/// parameters `skipped`, and pins the vertices of its nodes. Throws StepFailure.
Strip buildStrip(const StepInput& in, PredicatePositions& positions,
                 const std::vector<double>& skipped = {});

/// The triangles between two chains (node ids and their s), the first chain below. With a shared
/// end the other chain advances first, so that no triangle has three nodes on one rung.
std::vector<Triangle> stitch(const std::vector<int>& lower, const std::vector<double>& lowerS,
                             const std::vector<int>& upper, const std::vector<double>& upperS);

}  // namespace kerf::cut
