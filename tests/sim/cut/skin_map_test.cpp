#include "sim/cut/plan/wall/skin_map.h"

namespace kerf::cut {
namespace {

using Motion = std::function<Vec3(const Vec3& rest)>;

void moveBody(SurfaceMesh& mesh, const Motion& position, const Motion& velocity) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 rest = mesh.restPosition(v);
        mesh.setPosition(v, position(rest));
        mesh.setVelocity(v, velocity(rest));
    }
}

/// Of a step: the curves with walls, and the same once they are mapped.
struct Mapped {
    Stages stages;
    CutCurves curves;
};

Mapped map(const StepInput& in) {
    Mapped mapped;
    mapped.stages = stagesOf(in);
    mapped.curves = mapped.stages.walled;
    mapped.curves.nodes = mapFromSkin(in, mapped.stages.sheets, mapped.curves.nodes);
    return mapped;
}

std::vector<CutNode> wallNodes(const CutCurves& curves) {
    std::vector<CutNode> nodes;
    std::ranges::copy_if(curves.nodes, std::back_inserter(nodes),
                         [](const CutNode& node) { return node.kind == NodeKind::wall; });
    return nodes;
}

const Blade kFrom{{-1, 0.8, 0.01}, {1, 0.8, 0.02}};
const Blade kTo{{-1, -0.1, 0.02}, {1, -0.1, 0.01}};
const Vec3 kShift(0.03, -0.02, 0.05);
const Vec3 kDrift(1, -2, 3);

Vec3 shifted(const Vec3& rest) {
    return rest + kShift;
}
Vec3 drifting(const Vec3&) {
    return kDrift;
}

class SkinMapOfASphere : public ::testing::Test {
  protected:
    SkinMapOfASphere() { bench.begin(kFrom); }

    Mapped mapMoved(const Motion& position, const Motion& velocity) {
        moveBody(bench.mesh, position, velocity);
        return map(bench.stepTo(kTo));
    }

    StepBench bench{icosphere(2), 0.15};
};

TEST_F(SkinMapOfASphere, AtRestEachNodeRestsWhereItIs) {
    const std::vector<CutNode> nodes = wallNodes(map(bench.stepTo(kTo)).curves);
    EXPECT_GT(nodes.size(), 10U);
    for (const CutNode& node : nodes) {
        EXPECT_EQ(node.rest, node.position);
        EXPECT_EQ(node.velocity, Vec3(Vec3::Zero()));
    }
}

TEST_F(SkinMapOfASphere, OfABodyAtRestIsTheSameWhetherThatIsKnownOrNot) {
    StepInput in = bench.stepTo(kTo);
    const CutCurves known = map(in).curves;
    in.atRest = false;
    const CutCurves found = map(in).curves;
    for (int i = 0; i < sizeOf(known.nodes); ++i) {
        EXPECT_EQ(found.nodes[i].rest, known.nodes[i].rest);
        EXPECT_EQ(found.nodes[i].velocity, known.nodes[i].velocity);
    }
}

TEST_F(SkinMapOfASphere, OfABodyThatDriftsIsItsShift) {
    for (const CutNode& node : wallNodes(mapMoved(shifted, drifting).curves)) {
        EXPECT_LT((node.rest - (node.position - kShift)).norm(), 1e-12);
        EXPECT_LT((node.velocity - kDrift).norm(), 1e-11);
    }
}

// The ridge draws the map a little towards the identity.
TEST_F(SkinMapOfASphere, OfAnAffineMotionIsItsInverse) {
    Eigen::Matrix3d stretch;
    stretch << 1.3, 0.1, 0, -0.2, 0.9, 0.1, 0, 0.3, 1.1;
    const Vec3 spin(3, 1, -2);
    const std::vector<CutNode> nodes =
        wallNodes(mapMoved([&](const Vec3& rest) { return Vec3(stretch * rest + kShift); },
                           [&](const Vec3& rest) { return Vec3(spin.cross(rest)); })
                      .curves);
    EXPECT_GT(nodes.size(), 10U);
    for (const CutNode& node : nodes) {
        const Vec3 rest = stretch.inverse() * (node.position - kShift);
        EXPECT_LT((node.rest - rest).norm(), 1e-3);
        EXPECT_LT((node.velocity - spin.cross(rest)).norm(), 1e-2);
    }
}

TEST_F(SkinMapOfASphere, LeavesWhatTheSurfaceAndTheFrontKnow) {
    const Mapped mapped = mapMoved(shifted, drifting);
    for (int i = 0; i < sizeOf(mapped.curves.nodes); ++i) {
        const CutNode& before = mapped.stages.walled.nodes[i];
        const CutNode& after = mapped.curves.nodes[i];
        EXPECT_EQ(after.position, before.position);
        if (before.kind != NodeKind::wall) {
            EXPECT_EQ(after.rest, before.rest);
            EXPECT_EQ(after.velocity, before.velocity);
        }
    }
}

Vec3 bent(const Vec3& rest) {
    return rest +
           0.1 * Vec3(std::sin(3 * rest.y()), std::sin(3 * rest.z()), std::sin(3 * rest.x()));
}

// Nodes side by side come to rest side by side.
TEST_F(SkinMapOfASphere, IsContinuous) {
    moveBody(bench.mesh, bent, drifting);
    const StepInput in = bench.stepTo(kTo);
    const Mapped mapped = map(in);
    CutCurves beside = mapped.stages.walled;
    constexpr double kAside = 1e-6;
    for (CutNode& node : beside.nodes) {
        node.position += kAside * Vec3::UnitY();
    }
    beside.nodes = mapFromSkin(in, mapped.stages.sheets, beside.nodes);
    for (int i = 0; i < sizeOf(beside.nodes); ++i) {
        if (beside.nodes[i].kind == NodeKind::wall) {
            const double moved = (beside.nodes[i].rest - mapped.curves.nodes[i].rest).norm();
            EXPECT_TRUE(moved > 0.5 * kAside && moved < 2 * kAside) << moved;
        }
    }
}

// The surface before the stroke alone tells: what the stroke made is not fitted to itself.
TEST_F(SkinMapOfASphere, DoesNotAskTheVerticesOfItsOwnStroke) {
    const int old = bench.mesh.vertexCount();
    moveBody(bench.mesh, shifted, drifting);
    bench.cutTo({{-1, 0.2, 0.02}, {1, 0.2, 0.01}});
    for (int v = old; v < bench.mesh.vertexCount(); ++v) {
        bench.mesh.setRestPosition(v, bench.mesh.restPosition(v) + Vec3(1e-3, 2e-3, 0));
        bench.mesh.setVelocity(v, Vec3(100, 0, 0));
    }
    for (const CutNode& node : wallNodes(map(bench.stepTo(kTo)).curves)) {
        EXPECT_LT((node.rest - (node.position - kShift)).norm(), 1e-12);
        EXPECT_LT((node.velocity - kDrift).norm(), 1e-11);
    }
}

TEST(SkinMap, EachPieceHasAMapOfItsOwn) {
    const TriangleSoup two = joined(icosphereSoup(1), icosphereSoup(1), {1.2, 0, 0});
    StepBench bench(meshOf(two), 0.2);
    const auto isSecond = [](const Vec3& rest) { return rest.x() > 0.6; };
    moveBody(
        bench.mesh, [&](const Vec3& rest) { return isSecond(rest) ? shifted(rest) : rest; },
        [&](const Vec3& rest) { return isSecond(rest) ? kDrift : Vec3(Vec3::Zero()); });
    bench.begin({{-1, 0.8, 0.01}, {2, 0.8, 0.02}});
    const std::vector<CutNode> nodes =
        wallNodes(map(bench.stepTo({{-1, -0.1, 0.02}, {2, -0.1, 0.01}})).curves);
    int ofSecond = 0;
    for (const CutNode& node : nodes) {
        const bool second = isSecond(node.position);
        ofSecond += second;
        EXPECT_LT((node.position - node.rest - (second ? kShift : Vec3::Zero())).norm(), 1e-12);
        EXPECT_LT((node.velocity - (second ? kDrift : Vec3::Zero())).norm(), 1e-11);
    }
    EXPECT_GT(ofSecond, 4);
    EXPECT_GT(sizeOf(nodes) - ofSecond, 4);
}

// A chip that the stroke itself made has no vertex of the surface before.
TEST_F(SkinMapOfASphere, WithoutSamplesTheRimTells) {
    moveBody(bench.mesh, shifted, drifting);
    const StepInput in = bench.stepTo(kTo);
    Stages stages = stagesOf(in);
    ASSERT_EQ(stages.sheets.size(), 1U);
    stages.sheets.front().piece = 5;
    for (CutNode& node : stages.walled.nodes) {
        node.rest += Vec3(0, 0, 0.5);  // not what the skin around says
    }
    stages.walled.nodes = mapFromSkin(in, stages.sheets, stages.walled.nodes);
    for (const CutNode& node : wallNodes(stages.walled)) {
        EXPECT_LT((node.rest - (node.position - kShift + Vec3(0, 0, 0.5))).norm(), 1e-12);
        EXPECT_LT((node.velocity - kDrift).norm(), 1e-11);
    }
}

TEST(SkinMap, OfRandomStepsNodesRestInsideTheBody) {
    const std::uint32_t seed = fuzzSeed(81);
    SCOPED_TRACE("seed " + std::to_string(seed));
    int nodes = 0;
    int outside = 0;
    forRandomSteps(seed, 60, [&](const StepInput& in, const PlannedStep&) {
        SurfaceMesh rest = in.mesh;
        rest.exchangeShapes();
        for (const CutNode& node : wallNodes(map(in).curves)) {
            ++nodes;
            outside +=
                windingNumber(in.mesh, node.position) > 0.5 && windingNumber(rest, node.rest) < 0.5;
        }
    });
    EXPECT_GT(nodes, 50);
    EXPECT_LE(outside, 0.01 * nodes);
}

}  // namespace
}  // namespace kerf::cut
