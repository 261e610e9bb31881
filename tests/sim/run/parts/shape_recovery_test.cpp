#include "sim/run/parts/shape_recovery.h"

#include <gtest/gtest.h>

#include "sim/body/folded_triangles.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr double kTimeStep = 0.005;

/// A sphere that was mirrored, and goes where it is led.
class ShapeRecoveryTest : public ::testing::Test {
  protected:
    ShapeRecoveryTest() : mesh(test::cubeSphere(5)), model(buildBodyModel(mesh)) {
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
