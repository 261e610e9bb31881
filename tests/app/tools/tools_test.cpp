// The tools of the left button, as far as they need no body.
#include <Eigen/Geometry>

#include "app/scene/readout/cut_preview.h"
#include "app/tools/box_placement.h"
#include "app/tools/gizmo.h"
#include "app/tools/guillotine.h"
#include "app/tools/scalpel.h"
#include "app/tools/tool_box.h"

namespace kerf::app {
namespace {

class ToolBoxTest : public ::testing::Test {
  protected:
    ToolBoxTest() {
        bounds.add(Vec3(-0.5, 0, -0.5));
        bounds.add(Vec3(0.5, 1, 0.5));
        tools.begin(bounds);
    }

    ToolContext at(const Vec2& pixel) {
        const ViewFrame view{{.eye = {0, 0.5, 3}, .target = {0, 0.5, 0}}, 400, 300};
        return {view, pixel, {}, tools.settings(), stroke, bounds, section, nullptr};
    }
    void take(ui::ToolKind tool) {
        ui::ToolSettings wanted = tools.settings();
        wanted.tool = tool;
        tools.set(wanted, at({0, 0}));
    }

    Bounds bounds;
    BladeStroke stroke;
    std::optional<render::SectionPlane> section;
    ToolBox tools;
};

TEST_F(ToolBoxTest, AnotherToolEndsAStrokeThatIsHeld) {
    tools.inHand().press(at({50, 150}));
    tools.inHand().move(at({200, 150}));
    EXPECT_TRUE(tools.inHand().holds());
    EXPECT_FALSE(tools.holdsBody()) << "a blade is put away at once";
    EXPECT_TRUE(stroke.drawing());
    take(ui::ToolKind::guillotine);
    EXPECT_FALSE(stroke.drawing());
    take(ui::ToolKind::stroke);
    EXPECT_FALSE(tools.inHand().holds());
}

TEST_F(ToolBoxTest, TheGuillotineComesDownAndIsAboveTheBodyOnceItIsPutAway) {
    take(ui::ToolKind::guillotine);
    tools.inHand().trigger(at({0, 0}));
    EXPECT_EQ(tools.settings().guillotine.lowered, 1);
    EXPECT_GT(stroke.pending(), 0u);
    take(ui::ToolKind::stroke);
    EXPECT_EQ(tools.settings().guillotine.lowered, 0);
    EXPECT_EQ(stroke.pending(), 0u);
}

TEST_F(ToolBoxTest, TheGuillotineKeepsItsPoseWhileAnotherToolIsUsed) {
    take(ui::ToolKind::guillotine);
    ui::ToolSettings wanted = tools.settings();
    wanted.guillotine.length = 0.3;
    tools.set(wanted, at({0, 0}));
    const std::vector<Blade> way = tools.inHand().wayAhead(at({0, 0}));
    EXPECT_NEAR((way.front().b - way.front().a).norm(), 0.3, 1e-12);
    take(ui::ToolKind::stroke);
    take(ui::ToolKind::guillotine);
    EXPECT_EQ(tools.inHand().wayAhead(at({0, 0})).front().b, way.front().b);
}

TEST_F(ToolBoxTest, AnotherDocumentFitsTheSettingsAndLeavesTheToolInHand) {
    take(ui::ToolKind::pin);
    Bounds larger{Vec3::Zero(), Vec3(30, 40, 0)};
    tools.begin(larger);
    EXPECT_EQ(tools.settings().tool, ui::ToolKind::pin);
    EXPECT_DOUBLE_EQ(tools.settings().longest, 100);
    EXPECT_DOUBLE_EQ(tools.settings().pin.radius, 4);
}

Bounds ball() {
    return {Vec3::Constant(-0.5), Vec3::Constant(0.5)};
}

ViewFrame viewFrom(const Vec3& eye) {
    ViewFrame view{.camera = {}, .width = 1280, .height = 720};
    view.camera.eye = eye;
    return view;
}

constexpr ui::Rect kBetweenThePanels{320, 10, 640, 660};

TEST(BoxPlacement, ANewBoxStandsWhereNoPanelHidesIt) {
    for (const Vec3& eye : {Vec3(0, 0.6, 6), Vec3(0, 0.6, -6), Vec3(6, 0.6, 0), Vec3(4, 3, 4)}) {
        const ViewFrame view = viewFrom(eye);
        const StaticBox box = boxInView(ball(), -0.5, view, kBetweenThePanels);
        EXPECT_TRUE(isInView(box, view, kBetweenThePanels)) << eye.transpose();
        EXPECT_FALSE(box.bounds().overlaps(ball()));
        EXPECT_NEAR(box.bounds().low.y(), -0.5, 1e-9) << "on the floor";
    }
}

TEST(BoxPlacement, OnlyOneSideMayHaveRoom) {
    const ViewFrame view = viewFrom(Vec3(0, 0.6, 6));
    const ui::Rect left{0, 0, 820, 720};
    EXPECT_FALSE(isInView(boxBeside(ball(), -0.5), view, left)) << "it was put there always";
    EXPECT_LT(boxInView(ball(), -0.5, view, left).center.x(), 0);
}

// What leads the blade: the scalpel, the guillotine, and the preview of a cut.

constexpr double kRadius = 0.5;

TEST(PickSurface, FindsTheNearSideWithItsNormal) {
    const SurfaceMesh ball = cubeSphere(10, kRadius);
    const auto hit = pickSurface(ball, livingTriangles(ball), {Vec3(0.1, 0.2, 3), -Vec3::UnitZ()});
    ASSERT_TRUE(hit.has_value());
    EXPECT_GT(hit->position.z(), 0.4);
    EXPECT_NEAR(hit->position.norm(), kRadius, 0.01);
    EXPECT_GT(hit->normal.dot(hit->position.normalized()), 0.999);
    EXPECT_FALSE(pickSurface(ball, livingTriangles(ball), {Vec3(0.7, 0, 3), -Vec3::UnitZ()}));
    EXPECT_FALSE(pickSurface(ball, livingTriangles(ball), {Vec3(0, 0, 3), Vec3::UnitZ()}));
}

TEST(PickSurface, NoRaySlipsThroughAnEdgeOrACorner) {
    const SurfaceMesh ball = cubeSphere(8, kRadius);
    for (int t = 0; t < ball.triangleSlots(); ++t) {
        const Triangle& corners = ball.triangle(t);
        for (const double share : {0.0, 0.3, 0.5}) {
            const Vec3& a = ball.position(corners[0]);
            const Vec3 on = a + share * (ball.position(corners[1]) - a);
            const Vec3 direction = -on.normalized();
            EXPECT_TRUE(pickSurface(ball, livingTriangles(ball), {on - 3 * direction, direction}))
                << t << ", " << share;
        }
    }
}

TEST(CutPreview, APlaneThroughTheBallTouchesABeltAndLeavesACircle) {
    const SurfaceMesh ball = cubeSphere(10, kRadius);
    const double x = 0.013;
    const std::vector<Blade> way{
        {{x, 1, -1}, {x, 1, 1}}, {{x, 0, -1}, {x, 0, 1}}, {{x, -1, -1}, {x, -1, 1}}};
    const CutPreview preview = previewCut(ball, livingTriangles(ball), way);
    double length = 0;
    for (const auto& line : preview.wound) {
        EXPECT_NEAR(line[0].x(), x, 2e-4);
        length += (line[1] - line[0]).norm();
    }
    EXPECT_NEAR(length, 2 * EIGEN_PI * kRadius, 0.05);
    for (const int t : preview.touched) {
        double low = 1;
        double high = -1;
        for (const int v : ball.triangle(t)) {
            low = std::min(low, ball.position(v).x());
            high = std::max(high, ball.position(v).x());
        }
        EXPECT_LE(low, x + 2e-4);
        EXPECT_GE(high, x - 2e-4);
    }
    // Along edges of the mesh it is the same circle.
    const std::vector<Blade> middle{{{0, 1, -1}, {0, 1, 1}}, {{0, -1, -1}, {0, -1, 1}}};
    length = 0;
    for (const auto& line : previewCut(ball, livingTriangles(ball), middle).wound) {
        length += (line[1] - line[0]).norm();
    }
    EXPECT_NEAR(length, 2 * EIGEN_PI * kRadius, 0.05);
    const std::vector<Blade> miss{{{1, 1, -1}, {1, 1, 1}}, {{1, -1, -1}, {1, -1, 1}}};
    EXPECT_TRUE(previewCut(ball, livingTriangles(ball), miss).touched.empty());
}

/// The depth of a blade's tip below the ball, and the angle of its back.
struct ScalpelPose {
    double angle;
    double depth;
};

std::vector<ScalpelPose> posesTo(Scalpel& scalpel, double angle) {
    const Vec3 normal(std::sin(angle), std::cos(angle), 0);
    std::vector<ScalpelPose> poses;
    for (const Blade& blade : scalpel.moveTo({0, kRadius * normal, normal})) {
        EXPECT_GT(blade.a.norm(), kRadius);
        EXPECT_NEAR(blade.a.cross(blade.b).norm(), 0, 1e-12) << "upright";
        poses.push_back({std::atan2(blade.a.x(), blade.a.y()), kRadius - blade.b.norm()});
    }
    return poses;
}

TEST(Scalpel, EntersWhereItIsPressedAndReachesItsDepthSoon) {
    Scalpel scalpel(0.1);
    EXPECT_TRUE(posesTo(scalpel, 0).empty());
    EXPECT_TRUE(posesTo(scalpel, 0.01).empty()) << "no direction yet";
    const std::vector<ScalpelPose> in = posesTo(scalpel, 0.04);
    ASSERT_EQ(in.size(), 2U);
    EXPECT_NEAR(in[0].angle, 0, 1e-12);
    EXPECT_LT(in[0].depth, 0) << "in the air";
    EXPECT_GT(in[1].depth, 0);
    EXPECT_LT(in[1].depth, 0.1) << "it goes deeper on its way";
    const std::vector<ScalpelPose> on = posesTo(scalpel, 0.3);
    ASSERT_EQ(on.size(), 2U) << "a far move begins at the depth where that is reached";
    EXPECT_LT(on[0].angle, 0.12);
    EXPECT_NEAR(on[0].depth, 0.1, 5e-3) << "on the chord";
    EXPECT_NEAR(on[1].depth, 0.1, 1e-12);
}

TEST(Scalpel, GoesToAnotherDepthOnItsWay) {
    Scalpel scalpel(0.1);
    posesTo(scalpel, 0);
    posesTo(scalpel, 0.3);
    scalpel.setDepth(0.05);
    const std::vector<ScalpelPose> on = posesTo(scalpel, 0.4);
    ASSERT_EQ(on.size(), 1U);
    EXPECT_NEAR(on[0].depth, 0.05, 1e-12);
}

TEST(Guillotine, GoesFromAboveTheBodyToBelowIt) {
    Bounds bounds{Vec3(-0.2, 0, -1), Vec3(0.2, 0.5, 1)};
    const Guillotine guillotine(bounds);
    EXPECT_GT(guillotine.at(0).a.y(), 0.5);
    EXPECT_LT(guillotine.at(1).a.y(), 0);
    EXPECT_LT(guillotine.at(0).a.x(), -0.2) << "across the shorter side";
    EXPECT_GT(guillotine.at(0).b.x(), 0.2);
}

TEST(Guillotine, HandlesMoveTurnAndLengthenIt) {
    Bounds bounds{Vec3(-0.5, -0.5, -0.5), Vec3(0.5, 0.5, 0.5)};
    Guillotine guillotine(bounds);
    const Vec3 middle = guillotine.handles()[Guillotine::middle];
    guillotine.move(Guillotine::endB, middle + Vec3(0, 0, 0.9));
    EXPECT_NEAR((guillotine.at(0).b - (middle + Vec3(0, 0, 0.9))).norm(), 0, 1e-12);
    EXPECT_NEAR(guillotine.length(), 1.8, 1e-12);
    guillotine.move(Guillotine::bottom, middle + Vec3(0.3, -0.4, 0.7));
    EXPECT_NEAR(guillotine.drop(), 0.5, 1e-12) << "square to the blade";
    EXPECT_NEAR((guillotine.at(1).a - guillotine.at(0).a - Vec3(0.3, -0.4, 0)).norm(), 0, 1e-12);
    guillotine.move(Guillotine::middle, Vec3(1, 2, 3));
    EXPECT_NEAR((0.5 * (guillotine.at(0).a + guillotine.at(0).b) - Vec3(1, 2, 3)).norm(), 0, 1e-12);
    guillotine.move(Guillotine::endA, Vec3(1, 2, 3));
    EXPECT_NEAR(guillotine.length(), 1.8, 1e-12) << "a blade keeps a length";
}

// What drags of a gizmo mean, without a window and a body.

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
