// Hands that hold one lip of a slit, and two of them that hold it open.
#include "sim/mesh/surface_patch.h"

namespace kerf {
namespace {

constexpr double kPlane = 0.013;  // z of the slit [m]

class OneLip : public SimulationFixture {
  protected:
    void SetUp() override {
        SimulationFixture::SetUp();
        simulation.emplace(icosphere(3), weightless());
        simulation->setUndoBudget(100'000'000);
    }
    /// Down through the sphere's top to this height.
    void slitTo(double bottom) {
        for (double y = 0.7; y > bottom; y -= 0.03) {
            simulation->execute(MoveBlade{{{-1, y, kPlane}, {1, y, kPlane}}});
            simulation->step();
        }
        simulation->execute(LiftBlade{});
        simulation->step();
    }
    /// On the skin beside the slit's middle; side 1 or -1.
    static Vec3 beside(int side) { return Vec3(0, 0.5, kPlane + 0.04 * side).normalized() * 0.5; }
    /// Vertices that the hand holds whose other side is held as well.
    int heldOnBothSides(int hand) {
        const SurfaceMesh& mesh = simulation->mesh();
        const auto& held = heldBy(hand);
        return static_cast<int>(std::ranges::count_if(held, [&](const Hands::Held& a) {
            return std::ranges::any_of(held, [&](const Hands::Held& b) {
                return a.vertex != b.vertex && mesh.copyGroup(a.vertex) >= 0 &&
                       mesh.copyGroup(a.vertex) == mesh.copyGroup(b.vertex);
            });
        }));
    }
    const std::vector<Hands::Held>& heldBy(int hand) {
        return std::ranges::find(simulation->hands(), hand, &Hands::Hand::number)->held;
    }
    /// The farthest on the wrong side of the slit that one lies at rest [m].
    double strayOf(int hand, int side) {
        double farthest = 0;
        for (const Hands::Held& held : heldBy(hand)) {
            const double z = simulation->mesh().restPosition(held.vertex).z() - kPlane;
            farthest = std::max(farthest, -side * z);
        }
        return farthest;
    }
    /// How far the copies of the rim in the middle stand apart across the slit [m].
    double gap() {
        const SurfaceMesh& mesh = simulation->mesh();
        double widest = 0;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const bool middle = std::abs(mesh.restPosition(v).x()) < 0.12 &&
                                mesh.restPosition(v).y() > 0.4 && mesh.copyGroup(v) >= 0;
            for (const int copy :
                 middle ? mesh.copiesOfGroup(mesh.copyGroup(v)) : std::vector<int>{}) {
                widest = std::max(widest, mesh.position(copy).z() - mesh.position(v).z());
            }
        }
        return widest;
    }
    void retract(double width) {
        for (const int side : {1, -1}) {
            const int hand = side > 0 ? 50 : 51;
            ASSERT_EQ(simulation->execute(Grab{hand, beside(side), 0.12, true, side < 0}), "");
        }
        for (int step = 1; step <= 20; ++step) {
            for (const int side : {1, -1}) {
                const Vec3 to = beside(side) + Vec3(0, 0, side * width / 2 * step / 20);
                ASSERT_EQ(simulation->execute(Drag{side > 0 ? 50 : 51, to}), "");
            }
            simulation->step();
        }
    }
};

TEST_F(OneLip, AHandOnTheSurfaceTakesNoOtherLip) {
    slitTo(0);
    for (const int side : {1, -1}) {
        ASSERT_EQ(simulation->execute(Grab{1, beside(side), 0.2}), "");
        EXPECT_GT(heldOnBothSides(1), 4) << "a ball takes both";
        ASSERT_EQ(simulation->execute(Grab{1, beside(side), 0.2, true}), "");
        EXPECT_GT(heldBy(1).size(), 8U);
        EXPECT_EQ(heldOnBothSides(1), 0);
        EXPECT_LT(strayOf(1, side), 0.01) << "side " << side;
    }
}

TEST_F(OneLip, AHandOnOneHalfOfACutSphereTakesNoVertexOfTheOther) {
    slitTo(-0.7);
    ASSERT_EQ(simulation->report().pieces, 2);
    ASSERT_EQ(simulation->execute(Grab{1, beside(1), 10, true}), "");
    EXPECT_LT(strayOf(1, 1), 0.01);
    EXPECT_EQ(heldOnBothSides(1), 0);
}

TEST_F(OneLip, AHandAtTheEndOfASlitIsSmallerRatherThanOnBothSides) {
    slitTo(0.2);
    const double end = std::sqrt(0.25 - 0.2 * 0.2);
    for (const double x : {end, end - 0.05, end + 0.05}) {
        const Vec3 at = Vec3(x, 0.2, kPlane + 0.01).normalized() * 0.5;
        ASSERT_EQ(simulation->execute(Grab{1, at, 0.3, true}), "");
        EXPECT_EQ(heldOnBothSides(1), 0) << x;
        EXPECT_GE(heldBy(1).size(), 3U);
    }
}

TEST_F(OneLip, AHandTakesATriangleAtLeast) {
    ASSERT_EQ(simulation->execute(Grab{1, beside(1), 1e-6, true}), "");
    EXPECT_EQ(heldBy(1).size(), 3U);
}

TEST_F(OneLip, TwoHooksHoldASlitAsWideAsTheyAreApart) {
    slitTo(0);
    ASSERT_LT(gap(), 0.02);
    const std::size_t done = simulation->history().done();
    constexpr double kWidth = 0.16;
    retract(kWidth);
    ASSERT_EQ(simulation->history().done(), done + 1) << "one change";
    EXPECT_EQ(simulation->history().lastDone().name, "Hold open");
    run(180);
    EXPECT_NEAR(gap(), kWidth, 0.1 * kWidth) << "after a second";
    run(30);
    EXPECT_NEAR(gap(), kWidth, 0.1 * kWidth) << "it stays";
    simulation->execute(Release{50});
    simulation->execute(Release{51});
    run(200);
    EXPECT_LT(gap(), 0.03) << "it closes";
}

TEST_F(OneLip, OneUndoTakesBothHooksBack) {
    slitTo(0);
    const std::string before = simulation->stateHash();
    retract(0.1);
    run(20);
    ASSERT_EQ(simulation->hands().size(), 2U);
    ASSERT_EQ(simulation->execute(Undo{}), "");
    EXPECT_TRUE(simulation->hands().empty());
    EXPECT_EQ(simulation->stateHash(), before);
    ASSERT_EQ(simulation->execute(Redo{}), "");
    EXPECT_EQ(simulation->hands().size(), 2U);
}

TEST_F(OneLip, WhatIsPinnedIsMovedAndTurnedAtOnceAndUndone) {
    EXPECT_THAT(simulation->execute(MovePins{Vec3::UnitX()}), HasSubstr("Nothing is pinned"));
    ASSERT_EQ(simulation->execute(Pin{Ball{{0, 0.5, 0}, 0.2}, true}), "");
    const std::string before = simulation->stateHash();
    const SurfaceMesh mesh = simulation->mesh();
    EXPECT_THAT(simulation->execute(MovePins{Vec3(0, 1e7, 0)}), HasSubstr("1e6 m"));
    EXPECT_EQ(simulation->stateHash(), before);
    ASSERT_EQ(simulation->execute(MovePins{Vec3(0, 0.1, 0)}), "");
    ASSERT_EQ(simulation->execute(MovePins{Vec3(0, 0.1, 0), Vec3(0, 90, 0), true}), "");
    EXPECT_EQ(simulation->history().done(), 2U) << "two moves of one gesture";
    run(100);
    for (const std::uint32_t v : simulation->pinnedVertices()) {
        const int vertex = static_cast<int>(v);
        const Vec3& was = mesh.position(vertex);
        const Vec3 now = simulation->mesh().position(vertex);
        EXPECT_NEAR(now.y(), was.y() + 0.2, 1e-5);
        EXPECT_NEAR(std::hypot(now.x(), now.z()), std::hypot(was.x(), was.z()), 0.03);
    }
    EXPECT_GT(simulation->bounds().center().y(), 0.05) << "the body follows";
    ASSERT_EQ(simulation->execute(Undo{}), "");
    EXPECT_EQ(simulation->stateHash(), before);
}

// Short edges that a cut left go where the body stays folded.

constexpr double kMendedSize = 0.5;
constexpr double kEdge = 0.1;  // about that of the sphere [m]

struct ShortEdge {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
};

class MendingTest : public SimulationFixture {
  protected:
    void SetUp() override {
        SimulationFixture::SetUp();
        const SurfaceMesh mesh = cubeSphere(8, kMendedSize);
        uncutTriangles = mesh.triangleSlots();
        Params params = weightless();
        simulation.emplace(mesh, params);
        leadBlade(*simulation, {{0.02, 0.7, -1}, {0.02, 0.7, 1}},
                  {{0.02, -0.7, -1}, {0.02, -0.7, 1}}, 40);
        simulation->execute(LiftBlade{});
        run(10);
    }

    /// That the cut made and left.
    ShortEdge shortEdge() {
        const SurfaceMesh& mesh = simulation->mesh();
        for (int h = 3 * uncutTriangles; h < 3 * mesh.triangleSlots(); ++h) {
            if (mesh.alive(h / 3)) {
                ShortEdge edge{mesh.position(mesh.origin(h)), mesh.position(mesh.target(h))};
                const double length = (edge.to - edge.from).norm();
                if (length > 0.08 * kEdge && length < 0.15 * kEdge) {
                    return edge;
                }
            }
        }
        throw std::logic_error("the cut left no short edge");
    }
    /// A hand holds one end of a short edge beyond the other.
    void fold() {
        const ShortEdge edge = shortEdge();
        ASSERT_EQ(simulation->execute(Grab{0, edge.from, 1e-3 * kEdge}), "");
        const Vec3 beyond = edge.to + 4 * kEdge * (edge.to - edge.from).normalized();
        ASSERT_EQ(simulation->execute(Drag{0, beyond}), "");
        simulation->step();
    }
    bool isFolded() { return !foldedTriangles(simulation->mesh(), uncutTriangles).empty(); }
    int triangles() { return simulation->mesh().aliveTriangles(); }

    int uncutTriangles = 0;
};

TEST_F(MendingTest, WhatStaysFoldedLosesItsShortEdges) {
    ASSERT_FALSE(isFolded());
    const int before = triangles();
    fold();
    run(5);
    EXPECT_TRUE(isFolded());
    EXPECT_EQ(triangles(), before) << "most folds go by themselves";
    run(40);
    EXPECT_LT(triangles(), before);
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 1e-3);
}

TEST_F(MendingTest, WhatLiesUnfoldedKeepsThem) {
    const int before = triangles();
    run(80);
    EXPECT_EQ(triangles(), before);
}

TEST_F(MendingTest, AMomentKnowsHowLongTheBodyHasBeenFolded) {
    const int before = triangles();
    fold();
    run(5);
    const Checkpoint folded = simulation->checkpoint();
    run(40);
    const std::string mended = simulation->stateHash();
    EXPECT_LT(triangles(), before);
    simulation->goTo(folded);
    EXPECT_EQ(triangles(), before);
    run(40);
    EXPECT_EQ(simulation->stateHash(), mended);
}

}  // namespace
}  // namespace kerf
