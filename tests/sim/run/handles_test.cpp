// Hands that pull and pins that hold, as commands of a simulation.
#include <glad/gl.h>
#include <gmock/gmock.h>

#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

using test::weightless;
using testing::HasSubstr;

class HandlesTest : public test::GlTest {};

void run(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) {
        simulation.step();
    }
}

Vec3 middle(const SurfaceMesh& mesh) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : mesh.positions()) {
        sum += p / mesh.vertexCount();
    }
    return sum;
}

TEST_F(HandlesTest, AHandPullsTheBodyAlongAndLetsGo) {
    Params params = weightless();
    params.airDrag = 10;
    Simulation simulation(test::icosphere(2), params);
    ASSERT_EQ(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0.2}), "");
    const std::size_t held = simulation.hands().at(0).held.size();
    EXPECT_GT(held, 2u);
    EXPECT_LT(held, 30u);
    for (int step = 1; step <= 40; ++step) {
        ASSERT_EQ(simulation.execute(Drag{0, Vec3(0.5 + 0.01 * step, 0, 0)}), "");
        simulation.step();
    }
    run(simulation, 150);
    EXPECT_NEAR(middle(simulation.mesh()).x(), 0.4, 0.05);
    for (const Hands::Held& each : simulation.hands().at(0).held) {
        const Vec3 wanted = Vec3(0.9, 0, 0) + each.offset;
        EXPECT_LT((simulation.mesh().position(each.vertex) - wanted).norm(), 0.02);
    }
    ASSERT_EQ(simulation.execute(Release{0}), "");
    EXPECT_TRUE(simulation.hands().empty());
}

TEST_F(HandlesTest, TwoHandsPullABodyApartAndItComesBack) {
    Simulation simulation(test::icosphere(2), weightless());
    ASSERT_EQ(simulation.execute(Grab{1, Vec3(0.5, 0, 0), 0.25}), "");
    ASSERT_EQ(simulation.execute(Grab{2, Vec3(-0.5, 0, 0), 0.25}), "");
    for (int step = 1; step <= 20; ++step) {
        simulation.execute(Drag{1, Vec3(0.5 + 0.01 * step, 0, 0)});
        simulation.execute(Drag{2, Vec3(-0.5 - 0.01 * step, 0, 0)});
        simulation.step();
    }
    run(simulation, 40);
    const auto width = [&] { return simulation.bounds().high.x() - simulation.bounds().low.x(); };
    EXPECT_GT(width(), 1.3);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
    simulation.execute(Release{1});
    simulation.execute(Release{2});
    run(simulation, 150);
    EXPECT_NEAR(width(), 1, 0.05);
}

TEST_F(HandlesTest, PinnedVerticesHoldTheBodyUp) {
    Params params = weightless();
    params.gravity = Vec3(0, -9.81, 0);
    Simulation simulation(test::icosphere(2), params);
    ASSERT_EQ(simulation.execute(Pin{Bounds{{-1, 0.35, -1}, {1, 1, 1}}, true}), "");
    const std::vector<std::uint32_t> pinned = simulation.pinnedVertices();
    ASSERT_GT(pinned.size(), 3u);
    const SurfaceMesh before = simulation.mesh();
    run(simulation, 100);
    for (const std::uint32_t v : pinned) {
        const int vertex = static_cast<int>(v);
        EXPECT_EQ(simulation.mesh().position(vertex), before.position(vertex));
    }
    EXPECT_GT(middle(simulation.mesh()).y(), -0.3);
    EXPECT_LT(middle(simulation.mesh()).y(), -0.001) << "it sags";
    ASSERT_EQ(simulation.execute(Pin{Ball{{0, 0.5, 0}, 2}, false}), "");
    EXPECT_TRUE(simulation.pinnedVertices().empty());
    run(simulation, 60);
    EXPECT_LT(middle(simulation.mesh()).y(), -0.3) << "it falls";
}

TEST_F(HandlesTest, CopiesOfPinnedVerticesThatACutMakesStayPinned) {
    Simulation simulation(test::icosphere(2), weightless());
    ASSERT_EQ(simulation.execute(Pin{Ball{Vec3::Zero(), 1}, true}), "");
    const std::size_t before = simulation.pinnedVertices().size();
    for (int i = 0; i <= 20; ++i) {
        const double y = 0.7 - 0.07 * i;
        simulation.execute(MoveBlade{{{-1, y, 0.013}, {1, y, 0.013}}});
        simulation.step();
    }
    simulation.execute(LiftBlade{});
    simulation.step();
    ASSERT_EQ(simulation.report().pieces, 2);
    const SurfaceMesh& mesh = simulation.mesh();
    EXPECT_GE(simulation.pinnedVertices().size() + 20, before);
    for (const std::uint32_t v : simulation.pinnedVertices()) {
        ASSERT_GE(mesh.outgoing(static_cast<int>(v)), 0);
        EXPECT_EQ(mesh.velocity(static_cast<int>(v)), Vec3::Zero());
    }
}

TEST_F(HandlesTest, MistakesAreOneSentenceAndChangeNothing) {
    Simulation simulation(test::icosphere(1), weightless());
    const std::string hash = simulation.stateHash();
    EXPECT_THAT(simulation.execute(Grab{0, Vec3(5, 0, 0), 0.1}), HasSubstr("No free vertex"));
    EXPECT_THAT(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0}), HasSubstr("radius"));
    EXPECT_THAT(simulation.execute(Drag{3, Vec3::Zero()}), HasSubstr("Hand 3 holds nothing"));
    EXPECT_THAT(simulation.execute(Release{0}), HasSubstr("Hand 0 holds nothing"));
    EXPECT_THAT(simulation.execute(Pin{Ball{{9, 9, 9}, 1}, true}), HasSubstr("nothing was pinned"));
    EXPECT_THAT(simulation.execute(Pin{Ball{{0, 0, 0}, 9}, false}), HasSubstr("nothing was freed"));
    EXPECT_EQ(simulation.stateHash(), hash);
    EXPECT_TRUE(simulation.hands().empty());
    EXPECT_TRUE(simulation.pinnedVertices().empty());
}

TEST_F(HandlesTest, AHandThatHoldsAgainLetsGoOfWhatItHeld) {
    Simulation simulation(test::icosphere(2), weightless());
    ASSERT_EQ(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0.2}), "");
    ASSERT_EQ(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0.2}), "") << "its own are free";
    EXPECT_EQ(simulation.hands().size(), 1u);
    EXPECT_THAT(simulation.execute(Grab{1, Vec3(0.5, 0, 0), 0.2}), HasSubstr("No free vertex"));
}

TEST_F(HandlesTest, ALostPieceIsTakenBackAndSaidOnce) {
    Params params = weightless();
    params.iterations = 1;
    Simulation simulation(test::icosphere(1), params);
    // A hand that leaves at a speed that nothing real reaches.
    ASSERT_EQ(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0.3}), "");
    ASSERT_EQ(simulation.execute(Drag{0, Vec3(1e6, 0, 0)}), "");
    EXPECT_EQ(simulation.step().lostPieces, 1);
    EXPECT_EQ(simulation.step().lostPieces, 1) << "the hand still pulls";
    const std::vector<std::string> messages = simulation.takeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_THAT(messages[0], HasSubstr("1 piece of 1 left the range of numbers"));
    EXPECT_LT(middle(simulation.mesh()).norm(), 1e-3);
    ASSERT_EQ(simulation.execute(Release{0}), "");
    EXPECT_EQ(simulation.step().lostPieces, 0);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
}

}  // namespace
}  // namespace kerf
