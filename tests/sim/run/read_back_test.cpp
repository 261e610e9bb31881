// What the CPU reads of a body that is cut while it moves: results are the same bits whether the
// vertices near the blade come back from the GPU, or all of them.
#include <gtest/gtest.h>

#include "sim/run/simulation.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/nightly.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

class ReadBackTest : public test::GlTest {};

/// Where the blade is in each step; strokes end where the bool is false.
struct Pose {
    bool down = true;
    Blade blade;
};

/// From `from` to `to`, with the blade's half way along `across`.
void addStroke(std::vector<Pose>& poses, const Vec3& from, const Vec3& to, const Vec3& across,
               int steps) {
    for (int i = 0; i <= steps; ++i) {
        const Vec3 middle = from + (to - from) * (i / static_cast<double>(steps));
        poses.push_back({true, {middle - across, middle + across}});
    }
    poses.push_back({false, {}});
}

/// Through, an incision across it, one that hovers and comes back, a fast one.
std::vector<Pose> strokesAbout(const Vec3& middle, double radius) {
    std::vector<Pose> poses;
    const auto at = [&](double x, double y, double z) {
        return Vec3(middle + radius * Vec3(x, y, z));
    };
    const auto way = [&](double x, double y, double z) { return Vec3(radius * Vec3(x, y, z)); };
    addStroke(poses, at(0, 1.6, 0.13), at(0, -1.7, 0.1), way(1.7, 0.1, 0.05), 30);
    addStroke(poses, at(0.1, 0.9, -1.5), at(0.15, 0.7, 1.6), way(0.05, 0.5, 0.1), 25);
    addStroke(poses, at(-1.5, 0.6, 0), at(-0.4, 0.5, 0.1), way(0.1, 0.1, 1.5), 12);
    addStroke(poses, at(1.6, 0.05, 0), at(-1.6, -0.1, 0), way(0.1, 0.2, 1.6), 5);
    return poses;
}

/// Plays the strokes on both and compares them after each step. Returns how many steps cut.
int expectSame(Simulation& all, Simulation& near, const std::vector<Pose>& poses) {
    all.readAllBack(true);
    int cuts = 0;
    for (const Pose& pose : poses) {
        for (Simulation* simulation : {&all, &near}) {
            const Command command =
                pose.down ? Command(MoveBlade{pose.blade}) : Command(LiftBlade{});
            EXPECT_EQ(simulation->execute(command), "");
            simulation->step();
        }
        EXPECT_EQ(static_cast<int>(all.lastCut().outcome),
                  static_cast<int>(near.lastCut().outcome));
        EXPECT_EQ(all.report().triangles, near.report().triangles);
        EXPECT_EQ(all.report().volume, near.report().volume) << near.stepCount();
        cuts += near.lastCut().outcome == CutOutcome::cut;
        if (testing::Test::HasFailure()) {
            return cuts;
        }
    }
    return cuts;
}

void expectSameOf(const SurfaceMesh& body, const Params& params, const std::vector<Pose>& poses,
                  int leastCuts) {
    Simulation all(body, params);
    Simulation near(body, params);
    for (Simulation* simulation : {&all, &near}) {
        for (int i = 0; i < 20; ++i) {
            simulation->step();
        }
    }
    const int before = near.wholeReads();
    EXPECT_GE(expectSame(all, near, poses), leastCuts);
    // The first step that cuts needs the volume of the body, the last one cleans all of the stroke.
    constexpr int kStrokes = 4;
    EXPECT_LE(near.wholeReads() - before, 4 * kStrokes);
    EXPECT_EQ(all.stateHash(), near.stateHash());
}

TEST_F(ReadBackTest, AFallingSphereIsCutTheSame) {
    Params params;
    params.floor = -0.6;
    expectSameOf(test::cubeSphere(test::nightly() ? 16 : 10), params,
                 strokesAbout(Vec3(0, -0.1, 0), 0.5), 30);
}

TEST_F(ReadBackTest, AnIcosphereOnTheFloorIsCutTheSame) {
    Params params;
    params.floor = -0.5;
    params.youngsModulus = 3e5;
    expectSameOf(test::icosphere(test::nightly() ? 4 : 3), params, strokesAbout(Vec3::Zero(), 0.5),
                 40);
}

}  // namespace
}  // namespace kerf
