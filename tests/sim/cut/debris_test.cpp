// Chips that a stroke leaves, here the corner of a block.

namespace kerf {
namespace {

constexpr double kDepth = 0.015;  // of the cut below the corner
constexpr int kSteps = 12;

// The blade is led beside where it is asked for, by a thousandth of an edge (CutSettings::offset).
constexpr double kFarthestOffset = 4e-4;

/// Of the corner that a plane cuts off so far below it.
double chipVolume(double depth) {
    return std::pow(std::sqrt(3.0) * depth, 3) / 6;
}

/// How far below the corner of the block at rest the wound lies.
double woundDepth(const SurfaceMesh& mesh, const Vec3& corner) {
    double sum = 0;
    int count = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t) && mesh.kind(t) == SurfaceKind::wall) {
            for (const int v : mesh.triangle(t)) {
                sum += (corner - mesh.restPosition(v)).sum() / std::sqrt(3.0);
                ++count;
            }
        }
    }
    return sum / count;
}

Params floating(double debrisVolume) {
    Params params;
    params.iterations = 4;
    params.gravity = Vec3::Zero();
    params.floor.reset();
    params.debrisVolume = debrisVolume;
    return params;
}

class DebrisTest : public GlTest {
  protected:
    static Simulation makeBlock(double debrisVolume) {
        Simulation block(box(Vec3::Ones(), 4), floating(debrisVolume));
        block.setUndoBudget(std::size_t{1} << 28);
        return block;
    }
    /// The block reaches from `low` on by one along each axis.
    static Vec3 corner(Simulation& block) { return block.bounds().high; }
    static void play(Simulation& block, const Vec3& middle, const Vec3& along, const Vec3& way) {
        for (int i = 0; i <= kSteps; ++i) {
            const Vec3 at = middle + way * (2.0 * i / kSteps - 1);
            ASSERT_EQ(block.execute(MoveBlade{{at - along, at + along}}), "");
            block.step();
        }
        block.execute(LiftBlade{});
        block.step();
    }
    static void cutTheCornerOff(Simulation& block) {
        const Vec3 inwards = -Vec3::Ones() / std::sqrt(3.0);
        play(block, corner(block) + kDepth * inwards, 0.3 * Vec3(1, -1, 0), 0.3 * Vec3(1, 1, -2));
    }
};

TEST_F(DebrisTest, AChipIsRemovedAndAccountedFor) {
    Simulation block = makeBlock(1e-5);
    const Vec3 cornerAtRest = corner(block);
    cutTheCornerOff(block);
    const StepReport& report = block.report();
    EXPECT_EQ(report.pieces, 1);
    EXPECT_TRUE(report.closed);
    EXPECT_EQ(report.debris.pieces, 1);
    const double depth = woundDepth(block.mesh(), cornerAtRest);
    EXPECT_NEAR(depth, kDepth, kFarthestOffset);
    EXPECT_NEAR(report.debris.volume, chipVolume(depth), 1e-3 * chipVolume(depth));
    const PieceMap pieces = findPieces(block.mesh());
    EXPECT_NEAR(pieces.pieces.front().restVolume + report.debris.volume, 1, 1e-9);
    EXPECT_EQ(checkClosedManifold(block.mesh()), "");
    EXPECT_THAT(block.takeMessages(), ElementsAre(HasSubstr("removed a tiny fragment (")));
    block.step();
    EXPECT_EQ(block.report().debris.pieces, 0);
}

TEST_F(DebrisTest, NothingElseChanges) {
    Simulation removed = makeBlock(1e-5);
    Simulation kept = makeBlock(0);
    cutTheCornerOff(removed);
    cutTheCornerOff(kept);
    ASSERT_EQ(kept.report().pieces, 2);
    EXPECT_EQ(kept.report().debris.pieces, 0);
    const SurfaceMesh& a = removed.mesh();
    const SurfaceMesh& b = kept.mesh();
    ASSERT_EQ(a.triangleSlots(), b.triangleSlots());
    for (int t = 0; t < a.triangleSlots(); ++t) {
        if (a.alive(t)) {
            EXPECT_EQ(a.triangle(t), b.triangle(t));
        }
    }
    for (int v = 0; v < a.vertexCount(); ++v) {
        if (a.outgoing(v) >= 0) {
            EXPECT_EQ(a.position(v), b.position(v));
            EXPECT_EQ(a.velocity(v), b.velocity(v));
        }
    }
}

TEST_F(DebrisTest, UndoBringsItBackAndRedoTakesItAgain) {
    Simulation block = makeBlock(1e-5);
    const double whole = block.report().volume;
    cutTheCornerOff(block);
    const std::string without = block.stateHash();
    ASSERT_EQ(block.execute(Undo{}), "");
    EXPECT_EQ(block.report().triangles, 12 * 4 * 4);
    EXPECT_EQ(block.report().volume, whole);
    ASSERT_EQ(block.execute(Redo{}), "");
    EXPECT_EQ(block.stateHash(), without);
}

TEST_F(DebrisTest, AgainIsTheSame) {
    Simulation block = makeBlock(1e-5);
    cutTheCornerOff(block);
    const std::string first = block.stateHash();
    block.reset();
    cutTheCornerOff(block);
    EXPECT_EQ(block.stateHash(), first);
}

// The walls that the chip left have no other side any more.
TEST_F(DebrisTest, TheWoundCanBeCutAgain) {
    Simulation block = makeBlock(1e-5);
    cutTheCornerOff(block);
    play(block, corner(block) - Vec3(0.012, 0.5, 0.5), Vec3(0.01, 0, 0.9), Vec3(0, 0.8, 0));
    EXPECT_EQ(block.report().pieces, 2);
    EXPECT_TRUE(block.report().closed);
    EXPECT_EQ(checkClosedManifold(block.mesh()), "");
}

TEST_F(DebrisTest, WhatIsNotFromACutStays) {
    const TriangleSoup two =
        joined(boxSoup(Vec3::Ones(), 3), boxSoup(Vec3::Constant(0.01), 1), {2, 0, 0});
    Simulation simulation(meshOf(two), floating(1e-5));
    play(simulation, Vec3(0.5, 0.5, 0.5), Vec3(0.01, 0, 1.2), Vec3(0, 1.2, 0));
    EXPECT_EQ(simulation.report().pieces, 3);
    EXPECT_EQ(simulation.report().debris.pieces, 0);
}

}  // namespace
}  // namespace kerf
