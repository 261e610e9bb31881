#include "sim/solve/front_anchors.h"

#include <gtest/gtest.h>

#include "sim/body/body_model.h"
#include "sim/cut/stroke/cutter.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr double kStep = 0.005;
constexpr double kCatchUpSpeed = 2;

/// A sphere with a slit half way down, at rest.
struct SlitSphere {
    SlitSphere() {
        cutter.begin({{-1, 0.7, 0.013}, {1, 0.7, 0.013}});
        for (int i = 1; i <= 14; ++i) {
            cutter.advance({{-1, 0.7 - 0.05 * i, 0.013}, {1, 0.7 - 0.05 * i, 0.013}});
        }
        rung = cutter.rung();
        model = buildBodyModel(mesh);
    }
    std::vector<Anchor> anchors() const {
        return findFrontAnchors(rung, {mesh, model.pieceOfVertex, cutter.edgeLengthAtFront(),
                                       cutter.strokeSurface(), kStep, kCatchUpSpeed});
    }

    SurfaceMesh mesh = test::cubeSphere(8);
    int skinVertices = mesh.vertexCount();
    Cutter cutter{mesh, {}};
    std::vector<RungNode> rung;
    BodyModel model;
};

TEST(FrontAnchors, HoldsTheInnerFrontOnly) {
    const SlitSphere sphere;
    const std::vector<Anchor> anchors = sphere.anchors();
    ASSERT_GT(anchors.size(), 4u);
    for (const Anchor& anchor : anchors) {
        EXPECT_GE(anchor.vertex, sphere.skinVertices);
        EXPECT_LT(sphere.mesh.position(anchor.vertex).norm(), 0.5);
    }
}

// The tip of the blade stands in the material: nothing but the two walls would hold the front's
// end.
TEST(FrontAnchors, HoldsTheEndOfAFrontInsideTheBody) {
    SurfaceMesh mesh = test::cubeSphere(8);
    Cutter cutter(mesh, {});
    cutter.begin({{-0.7, 1.5, 0.013}, {-0.7, 0.2, 0.013}});
    for (int i = 1; i <= 14; ++i) {
        const double x = -0.7 + 0.05 * i;
        cutter.advance({{x, 1.5, 0.013}, {x, 0.2, 0.013}});
    }
    ASSERT_GE(cutter.rung().back().vertex, 0) << "the tip is inside";
    const BodyModel model = buildBodyModel(mesh);
    const std::vector<Anchor> anchors =
        findFrontAnchors(cutter.rung(), {mesh, model.pieceOfVertex, cutter.edgeLengthAtFront(),
                                         cutter.strokeSurface(), kStep, kCatchUpSpeed});
    const bool held = std::any_of(anchors.begin(), anchors.end(), [&](const Anchor& anchor) {
        return anchor.vertex == cutter.rung().back().vertex;
    });
    EXPECT_TRUE(held);
}

TEST(FrontAnchors, StandsStillAtRest) {
    for (const Anchor& anchor : SlitSphere().anchors()) {
        EXPECT_LT(anchor.velocity.norm(), 1e-6);
    }
}

TEST(FrontAnchors, GoesAlongWithTheBody) {
    SlitSphere sphere;
    const Vec3 velocity(0.3, -2, 0.1);
    for (int v = 0; v < sphere.mesh.vertexCount(); ++v) {
        sphere.mesh.setVelocity(v, velocity);
    }
    for (const Anchor& anchor : sphere.anchors()) {
        EXPECT_LT((anchor.velocity - velocity).norm(), 1e-6);
    }
}

TEST(FrontAnchors, PullsAStrayedVertexBackAtAModestSpeed) {
    SlitSphere sphere;
    const int strayed = sphere.anchors()[2].vertex;
    sphere.mesh.setPosition(strayed, sphere.mesh.position(strayed) + Vec3(0, 0, 0.001));
    EXPECT_NEAR(sphere.anchors()[2].velocity.z(), -0.001 / kStep, 1e-3);
    sphere.mesh.setPosition(strayed, sphere.mesh.position(strayed) + Vec3(0, 0, 0.1));
    EXPECT_NEAR(sphere.anchors()[2].velocity.z(), -kCatchUpSpeed, 1e-6);
}

TEST(FrontAnchors, FollowsAStretch) {
    // The ridge holds the fit towards the identity by 1e-3 of the trace.
    SlitSphere sphere;
    const Vec3 stretch(1.2, 0.9, 1.0);
    for (int v = 0; v < sphere.mesh.vertexCount(); ++v) {
        sphere.mesh.setPosition(v, sphere.mesh.restPosition(v).cwiseProduct(stretch));
    }
    for (const Anchor& anchor : sphere.anchors()) {
        EXPECT_LT(anchor.velocity.norm() * kStep, 0.02 * sphere.model.edgeLength);
    }
}

// What the front is held by reaches as far as the edges there are long, not those of the whole
// body.
TEST(FrontAnchors, GoByTheEdgeLengthAboutTheFront) {
    SurfaceMesh mesh = test::gradedSphere();
    const auto edgeAtFront = [&](double x) {
        Cutter cutter(mesh, {});
        cutter.begin({{x, 0.8, -0.7}, {x, 0.8, 0.7}});
        for (int i = 1; i <= 30; ++i) {
            cutter.advance({{x, 0.8 - 0.02 * i, -0.7}, {x, 0.8 - 0.02 * i, 0.7}});
        }
        const double edge = cutter.edgeLengthAtFront();
        cutter.finish();
        return edge;
    };
    EXPECT_GT(edgeAtFront(-0.31), 2 * edgeAtFront(0.31));
}

TEST(FrontAnchors, AreNoneOutsideAStroke) {
    SlitSphere sphere;
    sphere.rung.clear();
    EXPECT_TRUE(sphere.anchors().empty());
}

}  // namespace
}  // namespace kerf
