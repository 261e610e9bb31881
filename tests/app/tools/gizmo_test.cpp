// What drags of a gizmo mean, without a window and a body.
#include "app/tools/gizmo.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace kerf::app {
namespace {

TEST(GizmoMath, TheNearestPlaceOnAnAxis) {
    const render::Ray ray{Vec3(0.3, 2, 5), Vec3(0, 0, -1)};
    EXPECT_NEAR(*alongAxis(ray, Vec3(0.1, 0, 0), Vec3::UnitX()), 0.2, 1e-12);
    EXPECT_NEAR(*alongAxis(ray, Vec3::Zero(), Vec3::UnitY()), 2, 1e-12);
    EXPECT_FALSE(alongAxis(ray, Vec3::Zero(), Vec3::UnitZ())) << "the ray looks along it";
}

TEST(GizmoMath, TurnsAreThoseInThePlaneAcrossTheAxis) {
    const auto down = [](double x, double z) { return render::Ray{Vec3(x, 3, z), -Vec3::UnitY()}; };
    const Vec3 up = Vec3::UnitY();
    EXPECT_NEAR(*turnAbout(Vec3::Zero(), up, down(0, 1), down(1, 0)), 90, 1e-9);
    EXPECT_NEAR(*turnAbout(Vec3::Zero(), up, down(1, 0), down(0, 1)), -90, 1e-9);
    const render::Ray slanted{Vec3(1, 3, -3), Vec3(0, -1, 1).normalized()};
    EXPECT_NEAR(*turnAbout(Vec3::Zero(), up, down(0, 1), slanted), 90, 1e-9);
    const render::Ray away{Vec3(0, 3, 0), up};
    EXPECT_FALSE(turnAbout(Vec3::Zero(), up, down(0, 1), away)) << "it leads away from the plane";
}

TEST(GizmoMath, StepsAreRoundNumbers) {
    EXPECT_NEAR(roundStep(0.013), 0.02, 1e-12);
    EXPECT_NEAR(roundStep(0.02), 0.02, 1e-12);
    EXPECT_NEAR(roundStep(3.1), 5, 1e-12);
    EXPECT_NEAR(roundStep(7), 10, 1e-12);
    EXPECT_NEAR(snapped(-0.047, 0.02), -0.04, 1e-12);
}

TEST(GizmoMath, DistanceToALineEndsAtItsEnds) {
    EXPECT_NEAR(distanceToLine(Vec2(5, 3), Vec2(0, 0), Vec2(10, 0)), 3, 1e-12);
    EXPECT_NEAR(distanceToLine(Vec2(13, 4), Vec2(0, 0), Vec2(10, 0)), 5, 1e-12);
    EXPECT_NEAR(distanceToLine(Vec2(3, 4), Vec2(0, 0), Vec2(0, 0)), 5, 1e-12);
}

class GizmoTest : public ::testing::Test {
  protected:
    GizmoTest() {
        view.width = 800;
        view.height = 600;
        view.camera.eye = Vec3(2, 1.5, 4);
        view.camera.target = Vec3::Zero();
        frame.at = Vec3(0.1, 0, -0.1);
    }
    /// Takes what is at a pixel and goes to another one.
    GizmoChange drag(const Vec2& from, const Vec2& to, bool snaps = false) {
        gizmo.release();
        EXPECT_TRUE(gizmo.press(view, from, frame));
        gizmo.moved(view, 0.5 * (from + to), snaps);
        return gizmo.moved(view, to, snaps);
    }
    Vec2 pixelOf(const Vec3& point) const {
        const auto at = *view.toPixel(point);
        return {at.x, at.y};
    }
    double turnOfRing(int axis, int from, int to) {
        const std::vector<Vec2> ring = Gizmo::ringOf(view, frame, axis);
        gizmo.release();
        EXPECT_TRUE(gizmo.press(view, ring[from], frame));
        GizmoChange change;
        for (int i = from; i <= to; ++i) {
            change = gizmo.moved(view, ring[i], false);
        }
        const Eigen::AngleAxisd turn(change.turn);
        return turn.angle() * turn.axis()[axis] * 180 / std::numbers::pi;
    }

    ViewFrame view;
    GizmoFrame frame;
    Gizmo gizmo;
};

TEST_F(GizmoTest, AnArrowMovesAlongItsAxisWithThePointer) {
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 wanted = 0.25 * Vec3::Unit(axis);
        const Vec3 taken = frame.at + 0.2 * Vec3::Unit(axis);  // on its shaft
        const GizmoChange change = drag(pixelOf(taken), pixelOf(taken + wanted));
        EXPECT_LT((change.by - wanted).norm(), 1e-3) << axis;
        EXPECT_LT((change.by - change.by[axis] * Vec3::Unit(axis)).norm(), 1e-12);
        EXPECT_TRUE(change.turn.isIdentity());
        EXPECT_EQ(change.grow, Vec3(Vec3::Zero()));
    }
}

TEST_F(GizmoTest, WithSnapsItGoesInRoundSteps) {
    const Vec2 tip = *Gizmo::tipOf(view, frame, 0);
    const double by = drag(tip, tip + Vec2(47, 9), true).by.x();
    EXPECT_GT(by, 0);
    // 12 pixels are between 0.05 and 0.1 m here.
    EXPECT_NEAR(by / 0.1, std::round(by / 0.1), 1e-9);
    EXPECT_TRUE(gizmo.holds());
}

TEST_F(GizmoTest, ARingTurnsAsFarAsThePointerGoesRound) {
    // Of the 48 points of a ring.
    EXPECT_NEAR(turnOfRing(1, 5, 17), 90, 0.1);
    EXPECT_NEAR(turnOfRing(0, 12, 24), 90, 0.1);
    EXPECT_NEAR(turnOfRing(2, 3, 23), 150, 0.1);
    view.camera.eye = Vec3(-2, -1.5, -4);
    EXPECT_NEAR(turnOfRing(1, 5, 17), 90, 0.1) << "seen from behind";
}

TEST_F(GizmoTest, ARingSnapsToFifteenDegrees) {
    const std::vector<Vec2> ring = Gizmo::ringOf(view, frame, 2);
    const GizmoChange change = drag(ring[4], ring[9], true);
    const double degrees = Eigen::AngleAxisd(change.turn).angle() * 180 / std::numbers::pi;
    EXPECT_GT(degrees, 10);
    EXPECT_NEAR(degrees / 15, std::round(degrees / 15), 1e-6);
}

TEST_F(GizmoTest, ASideMovesAndTheOtherStays) {
    frame.half = Vec3(0.2, 0.3, 0.4);
    for (const int side : {1, -1}) {
        const Vec2 face = *Gizmo::faceOf(view, frame, 1, side);
        const Vec2 to = pixelOf(frame.at + side * 0.5 * Vec3::UnitY());
        const GizmoChange change = drag(face, to);
        EXPECT_NEAR(change.grow.y(), 0.2, 0.01);
        EXPECT_NEAR(change.by.y(), side * change.grow.y() / 2, 1e-12);
        EXPECT_EQ(change.grow.x(), 0);
    }
    const Vec2 face = *Gizmo::faceOf(view, frame, 1, 1);
    const GizmoChange inside = drag(face, face + Vec2(0, 500));
    EXPECT_GT(0.6 + inside.grow.y(), 0) << "a size stays above 0";
}

TEST_F(GizmoTest, TheCornerScalesTheWhole) {
    EXPECT_FALSE(Gizmo::isAt(view, *Gizmo::cornerOf(view, frame), frame));
    frame.scales = true;
    const Vec2 corner = *Gizmo::cornerOf(view, frame);
    const Vec2 middle = pixelOf(frame.at);
    EXPECT_NEAR(drag(corner, middle + 1.5 * (corner - middle)).factor, 1.5, 1e-9);
    EXPECT_NEAR(drag(corner, middle + 1.53 * (corner - middle), true).factor, 1.5, 1e-9);
    EXPECT_GT(drag(corner, middle).factor, 0);
}

TEST_F(GizmoTest, ItShowsItsPartsAndTheNumberOfTheDrag) {
    ui::Overlay overlay;
    const Vec2 tip = *Gizmo::tipOf(view, frame, 2);
    gizmo.addTo(overlay, view, tip, frame);
    EXPECT_EQ(overlay.axisDots.size(), 3U);
    EXPECT_EQ(std::ranges::count(overlay.axisDots, true, &ui::Overlay::AxisDot::hot), 1);
    EXPECT_TRUE(overlay.labels.empty());
    drag(tip, tip + Vec2(-20, 20));
    overlay = {};
    gizmo.addTo(overlay, view, Vec2(0, 0), frame);
    ASSERT_EQ(overlay.labels.size(), 1U);
    EXPECT_TRUE(overlay.labels[0].text.starts_with("z +")) << overlay.labels[0].text;
    EXPECT_FALSE(gizmo.press(view, Vec2(5, 5), frame));
}

}  // namespace
}  // namespace kerf::app
