// Pieces that are removed by a command.

namespace kerf {
namespace {

constexpr double kLeft = -0.4;
constexpr double kRight = 0.4;

/// A ball that two cuts have divided in three, of which the middle came off last.
class RemovePieceTest : public SimulationFixture {
  protected:
    void SetUp() override {
        SimulationFixture::SetUp();
        simulation.emplace(cubeSphere(6, 0.5), weightless());
        simulation->setUndoBudget(std::size_t{1} << 30);
        cutAt(-0.2);
        cutAt(0.2);
        ASSERT_EQ(simulation->report().pieces, 3);
    }
    static Blade bladeAt(double x, double y) { return {{x, y, -1}, {x, y, 1}}; }
    void cutAt(double x) {
        for (int i = 0; i <= 30; ++i) {
            simulation->execute(MoveBlade{bladeAt(x, 0.7 - 1.5 * i / 30)});
            simulation->step();
        }
        simulation->execute(LiftBlade{});
        run(2);
    }
    /// The one that reaches to this side.
    int pieceAt(double x) const {
        const std::vector<Bounds>& bounds = simulation->pieceBounds();
        const auto at = std::ranges::find_if(
            bounds, [x](const Bounds& b) { return b.low.x() < x && x < b.high.x(); });
        return static_cast<int>(at - bounds.begin());
    }
    std::set<double> volumes() {
        std::set<double> volumes;
        for (const Piece& piece : simulation->pieces().pieces) {
            volumes.insert(piece.volume);
        }
        return volumes;
    }
    std::string remove(int piece) { return simulation->execute(RemovePiece{piece}); }
};

TEST_F(RemovePieceTest, TheOthersStayToTheBitAndGoOn) {
    const std::vector<Vec3> before = simulation->mesh().positions();
    const std::set<double> volumesBefore = volumes();
    ASSERT_EQ(remove(pieceAt(kLeft)), "");
    EXPECT_EQ(simulation->report().pieces, 2);
    const SurfaceMesh& mesh = simulation->mesh();
    EXPECT_EQ(checkClosedManifold(mesh), "");
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0) {
            EXPECT_EQ(mesh.position(v), before[v]);
            EXPECT_GT(mesh.restPosition(v).x(), -0.25);
        }
    }
    EXPECT_EQ(volumes().size(), 2U);
    EXPECT_TRUE(std::ranges::includes(volumesBefore, volumes()));
    EXPECT_GT(simulation->bounds().low.x(), -0.25);
    cutAt(0);
    EXPECT_EQ(simulation->report().pieces, 3) << "and what is left is cut";
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    EXPECT_TRUE(simulation->takeMessages().empty());
}

TEST_F(RemovePieceTest, ItIsUndoneAndRedoneToTheBit) {
    const std::string before = simulation->stateHash();
    ASSERT_EQ(remove(pieceAt(kRight)), "");
    EXPECT_THAT(simulation->history().lastDone().name, testing::StartsWith("Delete piece "));
    const std::string after = simulation->stateHash();
    const Checkpoint removed = simulation->checkpoint();
    cutAt(-0.05);
    const std::string later = simulation->stateHash();
    simulation->goTo(removed);
    cutAt(-0.05);
    EXPECT_EQ(simulation->stateHash(), later) << "from a checkpoint as without one";
    simulation->goTo(removed);
    ASSERT_EQ(simulation->execute(Undo{}), "");
    EXPECT_EQ(simulation->stateHash(), before);
    EXPECT_EQ(simulation->report().pieces, 3);
    ASSERT_EQ(simulation->execute(Redo{}), "");
    EXPECT_EQ(simulation->stateHash(), after);
}

TEST_F(RemovePieceTest, WhatHoldsOrPullsItGoesWithIt) {
    for (const double side : {kLeft, kRight}) {
        const Ball ball{Vec3(1.25 * side, 0, 0), 0.15};
        ASSERT_EQ(simulation->execute(Pin{ball}), "");
        ASSERT_EQ(simulation->execute(
                      Pin{.region = Ball{Vec3(side, 0.3, 0), 0.1}, .velocity = Vec3(0, 0.1, 0)}),
                  "");
        ASSERT_EQ(simulation->execute(ApplyForce{ball, Vec3(0, 1, 0)}), "");
        const int hand = side < 0 ? 50 : 7;
        ASSERT_EQ(simulation->execute(Grab{hand, Vec3(side, -0.3, 0), 0.1}), "");
    }
    run(2);
    ASSERT_EQ(remove(pieceAt(kLeft)), "");
    ASSERT_EQ(simulation->motions().size(), 1U);
    ASSERT_EQ(simulation->forces().size(), 1U);
    ASSERT_EQ(simulation->hands().size(), 1U);
    EXPECT_EQ(simulation->hands()[0].number, 7);
    for (const std::uint32_t v : simulation->pinnedVertices()) {
        EXPECT_GT(simulation->mesh().restPosition(static_cast<int>(v)).x(), 0);
    }
    run(2);
    ASSERT_EQ(simulation->execute(Undo{}), "");
    EXPECT_EQ(simulation->motions().size(), 2U) << "and comes back with it";
    EXPECT_EQ(simulation->forces().size(), 2U);
    EXPECT_EQ(simulation->hands().size(), 2U);
    run(2);
}

TEST_F(RemovePieceTest, ARefusalSaysWhyAndChangesNothing) {
    EXPECT_EQ(remove(3), "There is no piece 3; they count from 0 to 2.");
    EXPECT_EQ(remove(-1), "There is no piece -1; they count from 0 to 2.");
    simulation->execute(MoveBlade{bladeAt(0, 0.9)});
    simulation->step();
    EXPECT_EQ(remove(0), "A stroke is under way; end it before you remove a piece.");
    simulation->execute(LiftBlade{});
    simulation->step();
    EXPECT_EQ(simulation->report().pieces, 3);
    ASSERT_EQ(remove(2), "");
    ASSERT_EQ(remove(1), "");
    EXPECT_EQ(remove(0), "This is the only piece; a scene keeps one.");
    ASSERT_EQ(simulation->execute(Undo{}), "");
    ASSERT_EQ(simulation->execute(Undo{}), "");
    EXPECT_EQ(simulation->report().pieces, 3);
}

}  // namespace
}  // namespace kerf
