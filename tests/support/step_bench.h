#pragma once

#include "sim/cut/commit/commit.h"
#include "sim/cut/plan/curves/intersections.h"
#include "sim/cut/plan/plan.h"
#include "sim/cut/plan/seams.h"
#include "sim/cut/plan/strip/swept_strip.h"
#include "sim/cut/plan/wall/wall.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf::test {

/// A body and a stroke through it, step by step and without the retry ladder: the lowest level of
/// that alone, and no clean-up. Holds all that a StepInput refers to.
class StepBench {
  public:
    /// `h`: edge length of walls [m].
    StepBench(const SurfaceMesh& body, double h);
    StepBench(const StepBench&) = delete;
    StepBench& operator=(const StepBench&) = delete;

    SurfaceMesh mesh;            ///< the body
    double offset = 0;           ///< of the blade, share of h
    bool seesSlitsOpen = false;  ///< older slits along the blade are seen open

    /// Starts a stroke: its rung is the blade, in the air.
    void begin(const Blade& at);
    /// What a step to `to` reads. Holds until the mesh, the rung or the bench changes.
    cut::StepInput stepTo(const Blade& to);
    /// Carries out a planned step; the rung goes on.
    cut::CommitResult carryOut(const cut::PlannedStep& step);
    /// Plans a step and carries it out. Throws StepFailure.
    cut::CommitResult cutTo(const Blade& to);

    /// Where the blade stood last.
    const std::vector<RungNode>& rung() const { return rung_; }

  private:
    void startTransit();

    double h_;
    cut::EdgeLengthField edgeLengths_{h_};
    std::optional<cut::StrokeSurface> surface_;
    int stroke_ = -1;
    int transit_ = 0;
    int firstVertexOfTransit_ = 0;
    std::map<int, Vec3> flushSides_;
    std::set<int> onSeams_;
    std::map<int, Vec3> sides_;
    std::vector<RungNode> rung_;
    // Of the step in hand.
    std::vector<RungNode> stepRung_;
    std::vector<int> pieceOfVertex_;
    std::optional<TriangleTree> tree_;
    std::optional<cut::BroadPhase> broadPhase_;
    cut::SlitOpening opening_;
};

/// The plan of a step, none where it is refused.
std::optional<cut::PlannedStep> planned(const cut::StepInput& in);

/// What the rooms of a plan make of one step, in turn.
struct Stages {
    cut::Strip strip;
    cut::CutCurves met;       ///< as intersect left the curves
    cut::CutCurves outlined;  ///< with the nodes of the outline
    cut::CutCurves seamed;    ///< with seams
    cut::CutCurves walled;    ///< with the inner nodes of the wall
    cut::Outline outline;
    std::vector<cut::WallSheet> sheets;
};

/// Runs the rooms on a step up to the walls. Throws StepFailure.
Stages stagesOf(const cut::StepInput& in);

/// The reason for which `act` throws StepFailure, "" where it does not.
std::string reasonOf(const std::function<void()>& act);

/// Shows each step of some random strokes to `visit`, before it is carried out: through small
/// bodies at rest and deformed, some across the walls of an older stroke. Steps that cut nothing or
/// are refused are left out; expects that few are. Nothing follows where an expectation has failed.
/// `seed` decides everything. Returns how many were shown.
int forRandomSteps(
    std::uint32_t seed, int strokes,
    const std::function<void(const cut::StepInput& in, const cut::PlannedStep& step)>& visit);

/// A tetrahedron with corners at the origin and at 1 on each axis.
SurfaceMesh unitTetrahedron();
/// The blade that lies in the plane z = `z` along x, far enough for any body of size 1, at `y`.
Blade bladeAt(double y, double z);

/// Twice the signed area of a triangle in the layout plane.
double doubleLayoutArea(const std::vector<cut::CutNode>& nodes, const Triangle& t);
/// The area within closed edges in the layout plane, counter-clockwise ones counting positive.
double layoutArea(const std::vector<cut::CutNode>& nodes,
                  const std::vector<cut::OutlineEdge>& edges);
/// The place of a point of the layout plane in the strip; none outside of it.
std::optional<Vec3> placeInStrip(const cut::Strip& strip, const Vec2& layout);
/// How many times the surface winds around p: 1 inside a body, 0 outside.
double windingNumber(const SurfaceMesh& mesh, const Vec3& p);

}  // namespace kerf::test
