#include "app/tools/box_placement.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

Bounds ball() {
    Bounds bounds;
    bounds.add(Vec3::Constant(-0.5));
    bounds.add(Vec3::Constant(0.5));
    return bounds;
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

}  // namespace
}  // namespace kerf::app
