// Pieces of one body that lie on each other: what rests has no speed, what is steep slides.
#include "tests/support/thin_walls.h"

namespace kerf {
namespace {

Params contactAlone() {
    Params params;
    params.contact = 1;
    params.gravity.setZero();
    return params;
}

/// A block of 0.6 x 0.4 x 0.6 m about the origin, cut level in two.
void cutLevel(Simulation& simulation) {
    makeStroke(simulation, {{-0.5, 0, 0.5}, {0.5, 1e-3, 0.5}}, {{-0.5, 0, -0.5}, {0.5, 1e-3, -0.5}},
               20);
}

/// The mean velocity of the upper half.
Vec3 upperVelocity(const SurfaceMesh& mesh, const PieceMap& pieces, int upper) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0 && pieces.ofVertex[v] == upper) {
            sum += mesh.velocity(v);
            ++count;
        }
    }
    return sum / count;
}

int pieceOfTop(const SurfaceMesh& mesh, const PieceMap& pieces) {
    int top = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0 && mesh.position(v).y() > mesh.position(top).y()) {
            top = v;
        }
    }
    return pieces.ofVertex[top];
}

class RestingPieces : public GlTest {};

// A contact that stops a part of the approach alone lets bodies fall at a speed that they do not
// move with: pushes take it back in each substep.
TEST_F(RestingPieces, SpeedsAreThoseOfTheMotion) {
    Params params = contactAlone();
    params.floor = -0.2;
    Simulation simulation(box({0.6, 0.4, 0.6}, 4), params);
    cutLevel(simulation);
    simulation.execute(SetParam{"gravity", Vec3(0, -9.81, 0)});
    step(simulation, 200);
    ASSERT_EQ(simulation.pieces().pieces.size(), 2U);
    const SurfaceMesh before = simulation.mesh();
    std::vector<Vec3> sums(before.vertexCount(), Vec3::Zero());
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps; ++i) {
        simulation.step();
        for (int v = 0; v < before.vertexCount(); ++v) {
            sums[v] += simulation.mesh().velocity(v) / kSteps;
        }
    }
    EXPECT_GT(simulation.report().contacts, 20);
    double sum = 0;
    for (int v = 0; v < before.vertexCount(); ++v) {
        const Vec3 way = simulation.mesh().position(v) - before.position(v);
        sum += (sums[v] - way / (kSteps * params.timeStep)).squaredNorm();
    }
    EXPECT_LT(std::sqrt(sum / before.vertexCount()), 2e-3) << "m/s";
}

/// How fast the upper half gains speed on the lower one, which is held, where gravity leans by 20
/// degrees: from 0.05 s on, when it has settled, to 0.2 s [m/s^2].
double accelerationOnTheLowerHalf(double friction) {
    Params params = contactAlone();
    params.floor.reset();
    params.airDrag = 0;
    params.youngsModulus = 1e6;
    params.friction = friction;
    Simulation simulation(box({0.6, 0.4, 0.6}, 4), params);
    cutLevel(simulation);
    const int upper = pieceOfTop(simulation.mesh(), simulation.pieces());
    simulation.execute(Pin{Bounds{{-1, -1, -1}, {1, -0.05, 1}}});
    const double tilt = 20 * EIGEN_PI / 180;
    simulation.execute(SetParam{"gravity", Vec3(std::sin(tilt), -std::cos(tilt), 0) * 9.81});
    const auto speedAfter = [&](int steps) {
        step(simulation, steps);
        return upperVelocity(simulation.mesh(), simulation.pieces(), upper).x();
    };
    const double early = speedAfter(10);
    return (speedAfter(30) - early) / (30 * params.timeStep);
}

TEST_F(RestingPieces, FrictionHoldsOnASlopeOrSlowsDown) {
    EXPECT_LT(accelerationOnTheLowerHalf(0.6), 0.1);
    const double angle = 20 * EIGEN_PI / 180;
    for (const double friction : {0.0, 0.15}) {
        const double rate = 9.81 * (std::sin(angle) - friction * std::cos(angle));
        EXPECT_NEAR(accelerationOnTheLowerHalf(friction), rate, 0.05 * rate) << friction;
    }
}

// Bodies of thin walls keep their volume once cut, and their walls don't pass through each other.
// All scenes: kerf_contact_bench walls.

Params newScene() {
    Params params;
    params.iterations = kAutoIterations;
    return params;
}

class ThinWallsTest : public GlTest {};

/// Plays scenes, and says what went wrong in each.
void expectRight(const std::vector<WallScene>& scenes) {
    for (const WallScene& scene : scenes) {
        const WallFigures figures = playWalls(scene, newScene());
        std::cout << text(scene) << ": " << text(figures) << "\n";
        EXPECT_TRUE(figures.isRight()) << text(scene);
    }
}

// At rest a card of a 500th of its diagonal swelled by 9 %, fins of a 200th by 20 %.
TEST_F(ThinWallsTest, KeepTheirVolumeAtRest) {
    expectRight({{"plate", 1 / 200.0, "twice", "rests", 0.005, 0.1},
                 {"fins", 1 / 80.0, "twice", "rests", 0.005, 0.1},
                 {"cup", 1 / 200.0, "slanted", "rests", 0.005, 0.1}});
}

TEST_F(ThinWallsTest, KeepTheirVolumeWhereTheyFall) {
    expectRight({{"plate", 1 / 38.0, "twice", "falls", 0.005, 0.25},
                 {"cup", 1 / 38.0, "slanted", "falls", 0.005, 0.2},
                 {"cup", 1 / 200.0, "flush", "falls", 0.005, 0.2}});
}

TEST_F(ThinWallsTest, KeepTheirVolumeWhereTheyAreDrawn) {
    expectRight({{"fins", 1 / 500.0, "flush", "drawn", 0.005, 0.2},
                 {"shell", 1 / 500.0, "slanted", "drawn", 0.005, 0.2}});
}

TEST_F(ThinWallsTest, AllKeepTheirVolumeAtNight) {
    KERF_BY_NIGHT();
    expectRight(wallScenes(7));
}

}  // namespace
}  // namespace kerf
