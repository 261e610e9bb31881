#include "sim/cut/plan/seams.h"

#include "sim/cut/plan/plan.h"

namespace kerf::cut {
namespace {

constexpr double kSeamH = 0.25;
constexpr double kRounding = 1e-9;  // of numbers that the two walls have in common

/// A box in two halves, cut in the plane z = 0.1, and a stroke that crosses that plane at a small
/// angle [rad] about the line y = `y`: it runs on in the gap, and cuts one wall where it enters and
/// the other where it leaves.
class CrossingAtAnAngle {
  public:
    CrossingAtAnAngle(double angle, double y, double gap = 0) : slope_(std::tan(angle)), y_(y) {
        bench.begin(bladeAt(1, 0.1));
        bench.cutTo(bladeAt(-1, 0.1));
        liftUpperHalf(gap);
        letMove();
        bench.seesSlitsOpen = true;
        bench.begin(blade(1));
    }

    Blade blade(double y) const {
        const double z = 0.1 + slope_ * (y - y_);
        return {{-2, y, z + 0.001}, {2, y, z - 0.001}};
    }

    StepBench bench{box(Vec3::Ones(), 2), kSeamH};

  private:
    void liftUpperHalf(double gap) {
        const PieceMap pieces = findPieces(bench.mesh);
        std::vector<double> height(pieces.pieces.size(), 0);
        for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
            height[pieces.ofVertex[v]] =
                std::max(height[pieces.ofVertex[v]], bench.mesh.position(v).z());
        }
        for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
            const double way = height[pieces.ofVertex[v]] > 0.3 ? gap : 0;
            bench.mesh.setPosition(v, bench.mesh.position(v) + Vec3(0, 0, way));
        }
    }

    /// Each vertex in a way of its own.
    void letMove() {
        for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
            bench.mesh.setVelocity(v, Vec3(v, -v, 0.5 * v * v));
        }
    }

    double slope_;
    double y_;
};

long long rounded(double x) {
    return std::llround(x / kRounding);
}

/// A node by what both walls of a slit have in common: its share of each point of the uncut body.
using PointKey = std::map<int, long long>;

PointKey keyOf(const SurfaceMesh& mesh, const CutNode& node) {
    PointKey key;
    const auto add = [&](int v, double share) { key[mesh.firstCopy(v)] += rounded(share); };
    if (node.kind == NodeKind::vertex) {
        add(node.a, 1);
    } else if (node.kind == NodeKind::edge) {
        add(node.a, 1 - node.t);
        add(node.b, node.t);
    } else {
        for (int i = 0; i < 3; ++i) {
            add(mesh.triangle(node.a)[i], node.weights[i]);
        }
    }
    return key;
}

/// What divides a triangle: its nodes and its segments, these from end to end or the other way.
struct DivisionKey {
    std::set<PointKey> nodes;
    std::set<std::pair<PointKey, PointKey>> segments;
    bool operator==(const DivisionKey&) const = default;
};

DivisionKey divisionOf(const SurfaceMesh& mesh, const CutCurves& curves, int t, bool turned) {
    DivisionKey key;
    const auto nodeKey = [&](int node) { return keyOf(mesh, curves.nodes[node]); };
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const auto hits = curves.onEdge.find(edgeOf(mesh.origin(h), mesh.target(h)));
        if (hits != curves.onEdge.end()) {
            for (const EdgeHit& hit : hits->second) {
                key.nodes.insert(nodeKey(hit.node));
            }
        }
    }
    for (const auto& [place, node] : curves.onFace) {
        if (place.first == t) {
            key.nodes.insert(nodeKey(node));
        }
    }
    if (const auto own = curves.segmentsOfTriangle.find(t);
        own != curves.segmentsOfTriangle.end()) {
        for (const int i : own->second) {
            const Segment& segment = curves.segments[i];
            const PointKey from = nodeKey(segment.from);
            const PointKey to = nodeKey(segment.to);
            key.segments.insert(turned ? std::pair(to, from) : std::pair(from, to));
        }
    }
    return key;
}

/// Returns how many walls are divided.
int expectFacingWallsAlike(const SurfaceMesh& mesh, const CutCurves& curves) {
    int walls = 0;
    for (const auto& [t, segments] : curves.segmentsOfTriangle) {
        if (mesh.kind(t) == SurfaceKind::wall) {
            const int facing = test::mirrorOf(mesh, t);
            EXPECT_GE(facing, 0);
            EXPECT_EQ(curves.segmentsOfTriangle.count(facing), 1U);
            EXPECT_EQ(divisionOf(mesh, curves, t, false), divisionOf(mesh, curves, facing, true));
            ++walls;
        }
    }
    return walls;
}

/// What `of` has at the place of a node on its own edge or triangle.
template <class Of>
Vec3 mixed(const SurfaceMesh& mesh, const CutNode& node, const Of& of) {
    if (node.kind == NodeKind::vertex) {
        return of(node.a);
    }
    if (node.kind == NodeKind::edge) {
        return (1 - node.t) * of(node.a) + node.t * of(node.b);
    }
    const Triangle& c = mesh.triangle(node.a);
    return node.weights[0] * of(c[0]) + node.weights[1] * of(c[1]) + node.weights[2] * of(c[2]);
}

void expectOnItsPlace(const SurfaceMesh& mesh, const CutNode& node) {
    EXPECT_LT(
        (node.position - mixed(mesh, node, [&](int v) -> const Vec3& { return mesh.position(v); }))
            .norm(),
        1e-12);
    EXPECT_LT(
        (node.rest - mixed(mesh, node, [&](int v) -> const Vec3& { return mesh.restPosition(v); }))
            .norm(),
        1e-12);
    EXPECT_LT(
        (node.velocity - mixed(mesh, node, [&](int v) -> const Vec3& { return mesh.velocity(v); }))
            .norm(),
        1e-12);
}

/// New nodes lie where their own edge or triangle says, and are told apart; older ones only move.
void expectSeamNodes(const SurfaceMesh& mesh, const CutCurves& before, const CutCurves& after) {
    for (int i = 0; i < sizeOf(after.nodes); ++i) {
        const CutNode& node = after.nodes[i];
        const bool isNew = i >= sizeOf(before.nodes);
        EXPECT_EQ(node.onSeam, isNew && node.kind != NodeKind::vertex);
        EXPECT_TRUE(isNew || node.kind == before.nodes[i].kind);
        if (node.kind != NodeKind::wall) {
            expectOnItsPlace(mesh, node);
        }
    }
}

/// The curves that the blade cuts stay; what is added runs in walls.
void expectOnlyAdds(const SurfaceMesh& mesh, const CutCurves& before, const CutCurves& after) {
    for (int i = 0; i < sizeOf(after.segments); ++i) {
        const Segment& segment = after.segments[i];
        if (i < sizeOf(before.segments)) {
            EXPECT_EQ(segment.triangle, before.segments[i].triangle);
            EXPECT_EQ(segment.from, before.segments[i].from);
            EXPECT_EQ(segment.to, before.segments[i].to);
        } else {
            EXPECT_EQ(mesh.kind(segment.triangle), SurfaceKind::wall);
        }
    }
}

int expectSeams(const StepInput& in) {
    const Stages stages = stagesOf(in);
    expectSeamNodes(in.mesh, stages.outlined, stages.seamed);
    expectOnlyAdds(in.mesh, stages.outlined, stages.seamed);
    EXPECT_TRUE(keepsMirrors(in.mesh, planStep(in).plan, kCloseNoise * in.h));
    return expectFacingWallsAlike(in.mesh, stages.seamed);
}

TEST(Seams, AStrokeAcrossAGapDividesBothWallsAndCutsOne) {
    CrossingAtAnAngle crossing(0.07, 0);
    const StepInput in = crossing.bench.stepTo(crossing.blade(-1));
    ASSERT_FALSE(in.opening.empty());
    EXPECT_GT(expectSeams(in), 4);
    const Stages stages = stagesOf(in);
    EXPECT_GT(stages.seamed.nodes.size(), stages.outlined.nodes.size());
    EXPECT_EQ(stages.outline.edges.size(),
              static_cast<std::size_t>(std::ranges::count_if(
                  stages.outline.edges,
                  [&](auto& edge) { return edge.from < sizeOf(stages.outlined.nodes); })))
        << "seams are no part of the outline";
}

// Seen open, the two walls may be met at different points of one edge.
TEST(Seams, NodesThatFaceEachOtherTakeOnePlace) {
    CrossingAtAnAngle crossing(0.07, 0);
    const StepInput in = crossing.bench.stepTo(crossing.blade(-1));
    const std::vector<int> walls = wallsOfPlus(in.mesh);
    const int wall = *std::ranges::find_if(walls, [&](int t) {
        return std::ranges::none_of(in.mesh.triangle(t),
                                    [&](int v) { return in.opening.displacement(v).isZero(0); });
    });
    const int mirror = test::mirrorOf(in.mesh, wall);
    const int a = in.mesh.triangle(wall)[0];
    const int b = in.mesh.triangle(wall)[1];
    DrawnCurves drawn(in.mesh);
    drawn.onEdge(a, b, 0.4, 0);
    drawn.onEdge(copyIn(in.mesh, mirror, a), copyIn(in.mesh, mirror, b), 0.5, 0);
    drawn.inFace(wall, {0.3, 0.3, 0.4}, 1);
    drawn.inFace(mirror, {0.2, 0.2, 0.6}, 1);
    const std::vector<CutNode> nodes = withSeams(in, drawn.curves).nodes;
    ASSERT_EQ(nodes.size(), 4U);
    EXPECT_EQ(keyOf(in.mesh, nodes[0]), keyOf(in.mesh, nodes[1]));
    EXPECT_EQ(keyOf(in.mesh, nodes[2]), keyOf(in.mesh, nodes[3]));
    for (const CutNode& node : nodes) {
        expectOnItsPlace(in.mesh, node);
    }
}

TEST(Seams, WithoutAnOpenSlitThereAreNone) {
    CrossingAtAnAngle crossing(0.07, 0);
    crossing.bench.seesSlitsOpen = false;
    const Stages stages = stagesOf(crossing.bench.stepTo(crossing.blade(-1)));
    EXPECT_EQ(stages.seamed.nodes.size(), stages.outlined.nodes.size());
    EXPECT_EQ(stages.seamed.segments.size(), stages.outlined.segments.size());
}

TEST(Seams, AddedTwiceAreThoseAddedOnce) {
    CrossingAtAnAngle crossing(0.07, 0);
    const StepInput in = crossing.bench.stepTo(crossing.blade(-1));
    const Stages stages = stagesOf(in);
    const CutCurves twice = withSeams(in, stages.seamed);
    EXPECT_EQ(twice.nodes.size(), stages.seamed.nodes.size());
    EXPECT_EQ(twice.segments.size(), stages.seamed.segments.size());
}

// Seen open, the two walls lie apart all the more where the body has moved them apart.
TEST(Seams, WallsThatHaveMovedApartAreStillDividedAlike) {
    CrossingAtAnAngle crossing(0.07, 0, 1e-3);
    EXPECT_GT(expectSeams(crossing.bench.stepTo(crossing.blade(-1))), 4);
}

TEST(Seams, StrokesThatCrossGapsInManyWaysLeaveWallsMirrored) {
    const std::uint32_t seed = fuzzSeed(91);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> uniform{0, 1};
    int walls = 0;
    int taken = 0;
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        CrossingAtAnAngle crossing(0.05 + 0.03 * uniform(random), 0.4 * uniform(random) - 0.2);
        const int steps = 1 + i % 4;
        for (int k = 1; k <= steps; ++k) {
            const StepInput in = crossing.bench.stepTo(crossing.blade(1 - 2.0 * k / steps));
            if (const std::optional<PlannedStep> step = planned(in)) {
                walls += expectSeams(in);
                crossing.bench.carryOut(*step);
                ++taken;
            }
        }
        EXPECT_EQ(checkClosedManifold(crossing.bench.mesh), "");
        EXPECT_EQ(checkMirroredWalls(crossing.bench.mesh), "");
    }
    EXPECT_GT(walls, 100);
    EXPECT_GT(taken, 15) << "of 50 steps";
}

TEST(Seams, ASeamThatMissesTheEdgeItFacesIsRefused) {
    CrossingAtAnAngle crossing(0.07, 0);
    const StepInput in = crossing.bench.stepTo(crossing.blade(-1));
    CutCurves curves = stagesOf(in).outlined;
    for (Segment& segment : curves.segments) {
        segment.stripTriangle += in.mesh.kind(segment.triangle) == SurfaceKind::wall ? 1000 : 0;
    }
    EXPECT_EQ(reasonOf([&] { withSeams(in, curves); }),
              "a seam does not meet the edge that it faces");
}

}  // namespace
}  // namespace kerf::cut
