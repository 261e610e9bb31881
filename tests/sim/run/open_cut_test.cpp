// The open cut with the solver: hollow while the blade moves, patched when it has left.

#include "sim/solve/body_view.h"
#include "tests/support/open_manifold.h"

namespace kerf {
namespace {

constexpr int kStrokeSteps = 30;

Params openParams() {
    Params params;
    params.iterations = 4;
    params.floor = -0.52;
    params.openCut = 1;
    return params;
}

Blade bladeAt(double x, int step) {
    const double y = 0.7 - 1.5 * step / kStrokeSteps;
    return {{x, y, -1}, {x, y, 1}};
}

class OpenCutTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        simulation.emplace(cubeSphere(6, 0.5), openParams());
        simulation->setUndoBudget(std::size_t{1} << 30);
    }
    void TearDown() override {
        simulation.reset();
        GlTest::TearDown();
    }
    /// Steps `from` to `to` of a stroke down through the body at x.
    void sweep(double x, int from, int to) {
        for (int i = from; i <= to; ++i) {
            ASSERT_EQ(simulation->execute(MoveBlade{bladeAt(x, i)}), "");
            simulation->step();
        }
    }
    void lift() {
        simulation->execute(LiftBlade{});
        simulation->step();
    }
    /// Vertices that are finite, within reach of the body.
    void expectSane() {
        const SurfaceMesh& mesh = simulation->mesh();
        EXPECT_EQ(checkFinite(mesh), "");
        const Bounds bounds = meshBounds(mesh);
        EXPECT_LT(bounds.diagonal(), 3.0);
    }

    std::optional<Simulation> simulation;
};

TEST_F(OpenCutTest, TheBodyIsOpenWhileTheBladeIsInItAndClosedAfter) {
    sweep(0.03, 0, 15);
    const StepReport& cutting = simulation->report();
    EXPECT_TRUE(cutting.open);
    EXPECT_FALSE(cutting.closed);
    const SurfaceMesh& mesh = simulation->mesh();
    EXPECT_EQ(checkOpenManifold(mesh), "");
    EXPECT_GT(borderHalfEdges(mesh).size(), 10u);
    const auto absent = static_cast<int>(absentTriangles(mesh).size());
    EXPECT_GT(absent, 20);
    EXPECT_EQ(cutting.triangles + absent, mesh.aliveTriangles());
    EXPECT_EQ(static_cast<int>(simulation->bodyView().triangleCount), cutting.triangles);
    EXPECT_FALSE(buildBodyModel(mesh).pieces[0].holdsVolume);
    expectSane();
    int patches = 0;
    for (int i = 16; i <= kStrokeSteps; ++i) {
        sweep(0.03, i, i);
        patches += simulation->lastCut().statistics.closing.patches;
    }
    EXPECT_EQ(patches, 1);
    EXPECT_FALSE(simulation->report().open);
    EXPECT_TRUE(simulation->report().closed);
    EXPECT_EQ(simulation->report().pieces, 2);
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    EXPECT_EQ(simulation->takeMessages(), std::vector<std::string>{});
    for (const PieceModel& piece : buildBodyModel(simulation->mesh()).pieces) {
        EXPECT_TRUE(piece.holdsVolume);
    }
    step(*simulation, 120);
    expectSane();
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 0.02);
}

TEST_F(OpenCutTest, TheOpenVolumeIsThatOfThePresentTriangles) {
    sweep(0.03, 0, 15);
    const PieceMap& map = simulation->pieces();
    ASSERT_EQ(map.pieces.size(), 1u);
    // Both about a vertex of the piece, maybe another: the wound's area vector lies between.
    Vec3 gap = Vec3::Zero();
    const SurfaceMesh& mesh = simulation->mesh();
    for (const int t : absentTriangles(mesh)) {
        gap += areaNormal(cornersOf(mesh, t)) / 2;
    }
    const double apart = gap.norm() * meshBounds(mesh).diagonal() / 3;
    EXPECT_NEAR(simulation->report().volume, map.pieces[0].volume, apart + 1e-6);
    EXPECT_GT(simulation->report().volume, 0.2);
}

TEST_F(OpenCutTest, AnIncisionGetsItsWallsAndSaysSo) {
    sweep(0.03, 0, 14);
    lift();
    EXPECT_TRUE(simulation->report().closed);
    EXPECT_EQ(simulation->report().pieces, 1);
    EXPECT_THAT(simulation->takeMessages(), Contains(HasSubstr("ended inside the body")));
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    expectSane();
}

TEST_F(OpenCutTest, TakesEffectWithTheNextStroke) {
    sweep(0.03, 0, 10);
    ASSERT_EQ(simulation->execute(SetParam{"open_cut", 0.0}), "");
    sweep(0.03, 11, 14);
    EXPECT_TRUE(simulation->report().open);
    sweep(0.03, 15, kStrokeSteps);
    lift();
    sweep(-0.15, 0, 15);
    EXPECT_FALSE(simulation->report().open);
    EXPECT_TRUE(simulation->report().closed);
}

TEST_F(OpenCutTest, RepeatsBitForBitAndGoesOnFromAMomentInTheMiddle) {
    sweep(0.03, 0, 14);
    const Checkpoint middle = simulation->checkpoint();
    const std::string then = simulation->stateHash();
    const auto goOn = [&] {
        sweep(0.03, 15, kStrokeSteps);
        lift();
        return simulation->stateHash();
    };
    const std::string after = goOn();
    EXPECT_EQ(simulation->report().pieces, 2);
    simulation->goTo(middle);
    EXPECT_EQ(simulation->stateHash(), then);
    EXPECT_EQ(goOn(), after);
    Simulation again(cubeSphere(6, 0.5), openParams());
    std::swap(*simulation, again);
    simulation->readAllBack(true);
    sweep(0.03, 0, 14);
    EXPECT_EQ(simulation->stateHash(), then);
    EXPECT_EQ(goOn(), after);
}

TEST_F(OpenCutTest, UndoInTheMiddleAndAfterBringsTheWholeBodyBack) {
    simulation->step();
    for (const int last : {14, kStrokeSteps}) {
        sweep(0.03, 0, last);
        ASSERT_EQ(simulation->execute(Undo{}), "");
        EXPECT_EQ(simulation->report().pieces, 1);
        EXPECT_EQ(simulation->report().triangles, 432);
        EXPECT_FALSE(simulation->report().open);
        EXPECT_LT(simulation->mesh().openStroke(), 0);
        EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
        simulation->step();
        ASSERT_EQ(simulation->execute(Redo{}), "");
        EXPECT_TRUE(simulation->report().closed);
        EXPECT_GT(simulation->report().triangles, 432);
        ASSERT_EQ(simulation->execute(Undo{}), "");
    }
}

}  // namespace
}  // namespace kerf
