#include "sim/run/parts/led_blade.h"
#include "sim/run/parts/shape_recovery.h"
#include "sim/run/parts/step_report.h"

namespace kerf {
namespace {

constexpr double kLag = 0.2;
constexpr double kWidth = 5;  // wider than all ways here

/// The middle of the cutting edge, once a blade along z was led through these places.
Vec3 edgeAfter(const std::vector<Vec3>& places, double lag = kLag) {
    LedBlade blade;
    for (const Vec3& place : places) {
        const Blade to{place - Vec3(0, 0, 0.5), place + Vec3(0, 0, 0.5)};
        blade.moveTo(to, kWidth, blade.edgeAt(to, lag));
    }
    return 0.5 * (blade.edge().a + blade.edge().b);
}

TEST(LedBlade, ItsEdgeStaysUntilTheLagIsTakenUpAndThenFollows) {
    EXPECT_LT(edgeAfter({{0, 0, 0}, {0.15, 0, 0}}).norm(), 1e-12);
    EXPECT_LT((edgeAfter({{0, 0, 0}, {0.15, 0, 0}, {0.5, 0, 0}}) - Vec3(0.3, 0, 0)).norm(), 1e-12);
    EXPECT_EQ(edgeAfter({{0, 0, 0}, {0.5, 0, 0}}, 0), Vec3(0.5, 0, 0));
}

TEST(LedBlade, ItsEdgeMovesAlongItselfWithoutLag) {
    const Vec3 edge = edgeAfter({{0, 0, 0}, {0.5, 0, 0}, {0.5, 0, -0.4}});
    EXPECT_LT((edge - Vec3(0.3, 0, -0.4)).norm(), 1e-12);
}

TEST(LedBlade, ItsEdgeFollowsWhereverTheFirstTouchWent) {
    for (const Vec3& first : {Vec3(0, 0.001, 0), Vec3(0, -0.001, 0), Vec3(-0.001, 0, 0)}) {
        const Vec3 edge = edgeAfter({{0, 0, 0}, first, first + Vec3(0.3, 0, 0), {0.9, 0, 0}});
        EXPECT_LT((edge - Vec3(0.7, 0, 0)).norm(), 0.002) << first.transpose();
    }
}

TEST(LedBlade, ItsEdgeFollowsACircleThatIsSmallerThanItsBody) {
    std::vector<Vec3> places;
    for (int i = 0; i <= 400; ++i) {
        const double turn = 0.01 * i * std::numbers::pi;
        places.emplace_back(std::cos(turn), std::sin(turn), 0);
    }
    EXPECT_NEAR(edgeAfter(places).norm(), std::sqrt(1 - kLag * kLag), 0.005);
}

TEST(LedBlade, ItsEdgeStaysWhileTheBladeTurnsWithinTheLag) {
    const Blade upright{{0, 0, -0.5}, {0, 0, 0.5}};
    const Blade turned{{0.09, 0, -0.5}, {-0.09, 0, 0.5}};
    LedBlade blade;
    blade.moveTo(upright, kWidth, upright);
    const Blade edge = blade.edgeAt(turned, kLag);
    EXPECT_LT(edge.a.head<2>().norm() + edge.b.head<2>().norm(), 0.01);
}

TEST(LedBlade, DrawnBackItsEdgeStaysUntilTheLagIsTakenUpAgain) {
    EXPECT_LT((edgeAfter({{0, 0, 0}, {0.9, 0, 0}, {0.6, 0, 0}}) - Vec3(0.7, 0, 0)).norm(), 1e-12);
    EXPECT_LT((edgeAfter({{0, 0, 0}, {0.9, 0, 0}, {0.2, 0, 0}}) - Vec3(0.4, 0, 0)).norm(), 1e-12);
}

/// A step that cut at its second try, with two fronts cut anew.
CutResult aStep() {
    CutResult step;
    step.outcome = CutOutcome::cut;
    step.statistics.tries = 2;
    step.statistics.resumed = 2;
    step.statistics.debris = {.pieces = 3, .volume = 0.25};
    return step;
}

/// A step that one group of pieces refused.
CutResult refusedStep() {
    CutResult step;
    step.outcome = CutOutcome::refused;
    step.statistics.tries = 1;
    step.statistics.refusedPieces = 1;
    return step;
}

void expectSums(const StrokeRecord& record, int times) {
    EXPECT_EQ(record.cutSteps, times);
    EXPECT_EQ(record.refusedSteps, times);
    EXPECT_EQ(record.retriedSteps, times);
    EXPECT_EQ(record.cutAnew, 2 * times);
    EXPECT_EQ(record.debris.pieces, 3 * times);
    EXPECT_DOUBLE_EQ(record.debris.volume, 0.25 * times);
}

TEST(StrokeRecord, SumsUpItsStepsAndOtherStrokes) {
    StrokeRecord record;
    EXPECT_FALSE(record.metBody());
    record.add(aStep());
    record.add(refusedStep());
    EXPECT_TRUE(record.metBody());
    expectSums(record, 1);
    StrokeRecord all;
    all.add(record);
    all.add(record);
    expectSums(all, 2);
}

constexpr double kTimeStep = 0.005;

/// A sphere that was mirrored, and goes where it is led.
class ShapeRecoveryTest : public ::testing::Test {
  protected:
    ShapeRecoveryTest() : mesh(cubeSphere(5)), model(buildBodyModel(mesh)) {
        params.timeStep = kTimeStep;
        params.gravity = Vec3::Zero();
        params.floor.reset();
        mirror();
    }

    void mirror() {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            mesh.setPosition(v, mesh.restPosition(v).cwiseProduct(Vec3(-1, 1, 1)));
        }
    }
    int begin() { return recovery.begin(sharesInsideOut(model, mesh)); }
    /// Returns how many vertices are led.
    std::size_t step() {
        const std::vector<shared::PullRecord> led = recovery.advance({model, mesh, params, held});
        for (const shared::PullRecord& r : led) {
            const int v = static_cast<int>(r.vertex);
            const Vec3 motion(r.motion_x, r.motion_y, r.motion_z);
            EXPECT_EQ(r.leads, 1U);
            EXPECT_LT(
                (mesh.position(v) + kTimeStep * motion - Vec3(r.target_x, r.target_y, r.target_z))
                    .norm(),
                1e-5);
            mesh.setPosition(v, mesh.position(v) + kTimeStep * motion);
            mesh.setVelocity(v, motion);
        }
        return led.size();
    }
    int stepsUntilLetGo() {
        int steps = 0;
        while (step() > 0) {
            ++steps;
        }
        return steps;
    }
    double farthestFromRest() const {
        double farthest = 0;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            farthest = std::max(farthest, (mesh.position(v) - mesh.restPosition(v)).norm());
        }
        return farthest;
    }

    SurfaceMesh mesh;
    BodyModel model;
    Params params;
    std::vector<std::uint32_t> held;
    ShapeRecovery recovery;
};

TEST_F(ShapeRecoveryTest, LeadsWhatWasMirroredBackWithinASecond) {
    EXPECT_EQ(begin(), 1);
    EXPECT_LT(stepsUntilLetGo() * kTimeStep, 1.0);
    EXPECT_FALSE(recovery.draws());
    EXPECT_EQ(sharesInsideOut(model, mesh).at(0), 0);
    const RestPose pose = fitRestPose([&] {
        std::vector<FittedVertex> vertices;
        vertices.reserve(mesh.vertexCount());
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            vertices.push_back({v, 1, mesh.position(v), mesh.restPosition(v), Vec3::Zero()});
        }
        return vertices;
    }());
    EXPECT_LT(pose.middle.norm(), 1e-3) << "as before";
}

TEST_F(ShapeRecoveryTest, LeavesAloneWhatIsWhole) {
    EXPECT_EQ(recovery.begin(std::vector<double>{0.01}), 0);
    EXPECT_EQ(step(), 0U);
}

TEST_F(ShapeRecoveryTest, DrawsAPieceOnceUntilSomebodyActs) {
    EXPECT_EQ(begin(), 1);
    EXPECT_EQ(begin(), 0) << "it is on its way";
    stepsUntilLetGo();
    mirror();
    EXPECT_EQ(begin(), 0);
    recovery.allowAgain();
    EXPECT_EQ(begin(), 1);
}

TEST_F(ShapeRecoveryTest, GivesUpInTime) {
    begin();
    int steps = 0;
    for (; step() > 0; ++steps) {
        mirror();  // whatever holds it
    }
    EXPECT_GT(steps * kTimeStep, 1);
    EXPECT_LT(steps * kTimeStep, 1.5);
}

TEST_F(ShapeRecoveryTest, FallsAsItDid) {
    params.gravity = Vec3(0, -9.81, 0);
    begin();
    const double time = stepsUntilLetGo() * kTimeStep;
    double height = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        height += (mesh.position(v).y() - mesh.restPosition(v).y()) / mesh.vertexCount();
    }
    EXPECT_NEAR(height, -0.5 * 9.81 * time * time, 0.05);
}

TEST_F(ShapeRecoveryTest, RisesOutOfTheFloorAndStaysOnIt) {
    params.floor = 0.0;
    params.gravity = Vec3(0, -9.81, 0);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v).cwiseProduct(Vec3(1, 0.01, 1)));
    }
    ASSERT_EQ(recovery.begin(std::vector<double>{1}), 1);
    stepsUntilLetGo();
    const Bounds bounds = meshBounds(mesh);
    EXPECT_NEAR(bounds.low.y(), 0, 0.02);
    EXPECT_NEAR(bounds.high.y(), 1, 0.05);
}

TEST_F(ShapeRecoveryTest, WhatIsStoppedThrowsNothing) {
    begin();
    double fastest = 0;
    while (step() > 0) {
        Vec3 mean = Vec3::Zero();
        for (int v = 0; v < mesh.vertexCount(); ++v) {  // a wall at x = 0
            if (mesh.position(v).x() < 0) {
                mesh.setPosition(v, mesh.position(v) + Vec3(-mesh.position(v).x(), 0, 0));
                mesh.setVelocity(v, mesh.velocity(v).cwiseProduct(Vec3(0, 1, 1)));
            }
            mean += mesh.velocity(v) / mesh.vertexCount();
        }
        fastest = std::max(fastest, mean.norm());
    }
    EXPECT_LT(fastest, 2.0);
}

TEST_F(ShapeRecoveryTest, GoesWhereItIsHeld) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.restPosition(v).y() > 0.3) {
            held.push_back(static_cast<std::uint32_t>(v));
            mesh.setPosition(v, mesh.restPosition(v));
        }
    }
    begin();
    EXPECT_EQ(step(), mesh.vertexCount() - held.size());
    stepsUntilLetGo();
    EXPECT_LT(farthestFromRest(), 0.05);
}

TEST_F(ShapeRecoveryTest, FollowsPiecesThroughACut) {
    begin();
    recovery.follow(std::vector<int>{0, 0, -1});
    EXPECT_TRUE(recovery.draws(0));
    EXPECT_TRUE(recovery.draws(1));
    EXPECT_FALSE(recovery.draws(2));
    EXPECT_FALSE(recovery.draws(7));
    recovery.stop();
    EXPECT_FALSE(recovery.draws());
}

}  // namespace
}  // namespace kerf
