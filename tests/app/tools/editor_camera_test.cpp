#include "app/tools/editor_camera.h"

namespace kerf::app {
namespace {

using ui::Button;

render::Camera camera() {
    return {.eye = {0, 0, 5}};
}

TEST(EditorCamera, TheLeftButtonBelongsToTheBlade) {
    EXPECT_FALSE(EditorCamera{}.press({Button::left, true, {}}));
    EXPECT_FALSE(EditorCamera{}.press({Button::left, true, {.shift = true}}));
}

TEST(EditorCamera, RightOrAltLeftOrbits) {
    for (const ui::ButtonChange press : {ui::ButtonChange{Button::right, true, {}},
                                         ui::ButtonChange{Button::left, true, {.alt = true}}}) {
        EditorCamera control(camera());
        ASSERT_TRUE(control.press(press));
        EXPECT_TRUE(control.drag({100, 0}, 720));
        const render::Camera moved = control.shown();
        EXPECT_EQ(moved.target, camera().target);
        EXPECT_LT(moved.eye.x(), -0.1) << "the scene follows the pointer to the right";
        EXPECT_NEAR((moved.eye - moved.target).norm(), 5, 1e-9);
    }
}

TEST(EditorCamera, TheMouseIsThatOfBlenderOrOfCadToo) {
    using ui::MouseScheme;
    using ui::ViewMotion;
    const auto middle = [](MouseScheme scheme, const ui::Modifiers& held) {
        return motionOf(scheme, Button::middle, held);
    };
    EXPECT_EQ(middle(MouseScheme::blender, {}), ViewMotion::orbit);
    EXPECT_EQ(middle(MouseScheme::blender, {.shift = true}), ViewMotion::pan);
    EXPECT_EQ(middle(MouseScheme::blender, {.control = true}), ViewMotion::zoom);
    EXPECT_EQ(middle(MouseScheme::cad, {.control = true}), ViewMotion::pan);
    EXPECT_EQ(middle(MouseScheme::cad, {.shift = true}), ViewMotion::zoom);
    for (int i = 0; i < ui::kMouseSchemes; ++i) {
        const auto scheme = static_cast<MouseScheme>(i);
        EXPECT_EQ(motionOf(scheme, Button::left, {.shift = true}), ViewMotion::none) << "a tool's";
        EXPECT_EQ(motionOf(scheme, Button::left, {.alt = true}), ViewMotion::orbit);
    }
}

TEST(EditorCamera, ADragZooms) {
    EditorCamera control(camera());
    ASSERT_TRUE(control.press({Button::middle, true, {.control = true}}, ui::MouseScheme::blender));
    EXPECT_TRUE(control.drag({0, -72}, 720));
    EXPECT_LT(control.shown().eye.z(), 4.9) << "nearer as it goes up";
    EXPECT_TRUE(control.drag({0, 144}, 720));
    EXPECT_GT(control.shown().eye.z(), 5.1);
}

TEST(EditorCamera, NoZoomOrPanLosesTheBody) {
    Bounds body{Vec3(-1, -1, -1), Vec3(1, 1, 1)};
    for (const double notches : {400.0, -400.0}) {
        EditorCamera control(camera());
        control.zoom(notches, Vec2(0.3, 0.2), 1.5);
        render::Camera moved = control.shown();
        const Vec3 before = camera().forward();
        moved.pan(1e9, 1e9);
        keepNear(moved, body);
        EXPECT_TRUE(moved.eye.allFinite());
        EXPECT_LT((moved.eye - moved.forward()).norm(), 1000);
        EXPECT_GT((moved.eye - moved.target).norm(), 1e-3);
        EXPECT_NEAR(moved.forward().dot(before), 1, 1e-6);
        const render::Camera kept = moved;
        keepNear(moved, body);
        EXPECT_NEAR((moved.eye - kept.eye).norm(), 0, 1e-9) << "what is near enough stays";
    }
}

TEST(EditorCamera, MiddleOrShiftRightPans) {
    for (const ui::ButtonChange press : {ui::ButtonChange{Button::middle, true, {}},
                                         ui::ButtonChange{Button::right, true, {.shift = true}}}) {
        EditorCamera control(camera());
        ASSERT_TRUE(control.press(press));
        EXPECT_TRUE(control.drag({72, 0}, 720));
        const render::Camera moved = control.shown();
        EXPECT_LT(moved.target.x(), -0.01);
        EXPECT_EQ(moved.eye - moved.target, camera().eye - camera().target);
    }
}

TEST(EditorCamera, ReleaseEndsTheDrag) {
    EditorCamera control(camera());
    control.press({Button::right, true, {}});
    control.release(Button::left);
    EXPECT_TRUE(control.dragging());
    control.release(Button::right);
    EXPECT_FALSE(control.drag({100, 100}, 720));
    EXPECT_EQ(control.shown().eye, camera().eye);
}

TEST(EditorCamera, TheWheelZoomsIn) {
    EditorCamera control(camera());
    const render::Camera& moved = control.shown();
    control.zoom(1, {0, 0}, 1.5);
    EXPECT_LT((moved.eye - moved.target).norm(), 5);
    control.zoom(-1, {0, 0}, 1.5);
    EXPECT_NEAR((moved.eye - moved.target).norm(), 5, 1e-9);
}

TEST(LookAlong, KeepsTargetAndDistance) {
    for (const auto& [view, direction] :
         {std::pair{AxisView::front, Vec3(0, 0, 1)}, std::pair{AxisView::right, Vec3(1, 0, 0)},
          std::pair{AxisView::top, Vec3(0, 1, 0)}, std::pair{AxisView::back, Vec3(0, 0, -1)},
          std::pair{AxisView::left, Vec3(-1, 0, 0)}, std::pair{AxisView::bottom, Vec3(0, -1, 0)}}) {
        render::Camera moved{.eye = {3, 4, 0}, .target = {0, 0, 0}};
        lookAlong(moved, view);
        const bool alongUp = std::abs(direction.y()) > 0.5;  // leans a little, to know what is up
        EXPECT_NEAR((moved.eye - 5 * direction).norm(), 0, alongUp ? 1e-3 : 1e-9);
        EXPECT_NEAR((moved.eye - moved.target).norm(), 5, 1e-9);
        EXPECT_TRUE(moved.view().allFinite());
    }
}

TEST(LookAlong, FromAboveTheRightStaysRight) {
    render::Camera moved{.eye = {3, 4, 0}, .target = {0, 0, 0}};
    lookAlong(moved, AxisView::top);
    const Eigen::Vector3f right = moved.view().row(0).head<3>();
    EXPECT_NEAR((right - Eigen::Vector3f::UnitX()).norm(), 0, 1e-3);
}

TEST(EditorCamera, EndsAtItsDestinationAndKeepsTheDistanceOnTheWay) {
    EditorCamera flight(camera());
    const render::Camera& shown = flight.shown();
    render::Camera wanted = shown;
    lookAlong(wanted, AxisView::right);
    flight.flyTo(wanted);
    double last = (shown.eye - wanted.eye).norm();
    int pictures = 0;
    for (; flight.flying(); ++pictures) {
        const Vec3 before = shown.eye;
        flight.advance(1.0 / 60);
        ASSERT_NE(shown.eye, before);
        ASSERT_LE((shown.eye - wanted.eye).norm(), last + 1e-9);
        last = (shown.eye - wanted.eye).norm();
        ASSERT_NEAR((shown.eye - shown.target).norm(), 5, 1e-5);
    }
    EXPECT_GT(pictures, 5);
    EXPECT_LT(pictures, 20);
    EXPECT_EQ(shown.eye, wanted.eye);
    EXPECT_EQ(shown.up, wanted.up);
    flight.advance(1);
    EXPECT_EQ(shown.eye, wanted.eye);
}

TEST(EditorCamera, LandsAtOnceWhereSomethingIsDone) {
    EditorCamera flight(camera());
    render::Camera wanted = flight.shown();
    lookAlong(wanted, AxisView::top);
    flight.flyTo(wanted);
    flight.advance(0.05);
    EXPECT_EQ(flight.destination().eye, wanted.eye);
    EXPECT_FALSE(flight.press({Button::left, true, {}})) << "that belongs to a tool";
    EXPECT_EQ(flight.shown().eye, wanted.eye);
    EXPECT_FALSE(flight.flying());
}

TEST(EditorCamera, AFlightGoesOnFromWhereTheOneBeforeEnds) {
    EditorCamera shown(camera());
    shown.flyTo(AxisView::top);
    shown.advance(0.05);
    Bounds body{Vec3(-1, -1, -1), Vec3(1, 1, 1)};
    shown.flyToFrame(body);
    shown.advance(1);
    EXPECT_FALSE(shown.flying());
    EXPECT_LT(shown.shown().forward().y(), -0.99);
}

}  // namespace
}  // namespace kerf::app
