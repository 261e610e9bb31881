#include "app/editor/view/redraw.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

Redraw drawn() {
    Redraw redraw(true);
    redraw.takeScene();
    while (redraw.pending()) {
        redraw.countUpdate(true);
    }
    return redraw;
}

TEST(Redraw, AtFirstAllIsDrawn) {
    Redraw redraw(true);
    EXPECT_TRUE(redraw.takeScene());
    EXPECT_TRUE(redraw.pending()) << "the panels";
    EXPECT_FALSE(drawn().takeScene());
}

TEST(Redraw, PanelsSettleInTwoQuietUpdates) {
    Redraw redraw = drawn();
    redraw.panels();
    redraw.countUpdate(true);
    EXPECT_TRUE(redraw.pending());
    redraw.countUpdate(false);  // something was said or done meanwhile
    redraw.countUpdate(true);
    EXPECT_TRUE(redraw.pending());
    redraw.countUpdate(true);
    EXPECT_FALSE(redraw.pending());
    EXPECT_FALSE(redraw.takeScene());
}

TEST(Redraw, ASceneThatChangedIsShownByThePanelsToo) {
    Redraw redraw = drawn();
    redraw.scene();
    EXPECT_TRUE(redraw.takeScene());
    EXPECT_FALSE(redraw.takeScene());
    EXPECT_TRUE(redraw.pending());
}

TEST(Redraw, StepsWaitUntilTheyAreToBeShown) {
    Redraw redraw = drawn();
    redraw.steps();
    EXPECT_TRUE(redraw.stepsPending());
    EXPECT_FALSE(redraw.pending()) << "the panels are drawn with them";
    EXPECT_FALSE(redraw.takeScene(false));
    EXPECT_FALSE(redraw.takeShown());
    EXPECT_TRUE(redraw.takeScene(true));
    EXPECT_FALSE(redraw.stepsPending());
    EXPECT_TRUE(redraw.takeShown());
    EXPECT_FALSE(redraw.takeShown());
    redraw.steps();
    redraw.scene();
    EXPECT_TRUE(redraw.takeScene(false)) << "what else has changed shows at once, and they with it";
    EXPECT_FALSE(redraw.stepsPending());
}

TEST(Redraw, WhatIsPutOffIsPendingNoMoreAndDrawnOnceItIsAskedFor) {
    Redraw redraw = drawn();
    redraw.steps();
    redraw.putOff();
    redraw.putOff();
    EXPECT_FALSE(redraw.stepsPending());
    EXPECT_TRUE(redraw.takeScene());
    EXPECT_FALSE(redraw.takeScene());
}

}  // namespace
}  // namespace kerf::app
