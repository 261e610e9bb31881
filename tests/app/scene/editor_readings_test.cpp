#include "app/scene/readout/editor_readings.h"

#include <gmock/gmock.h>

#include "app/editor/storage/file_saving.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"

namespace kerf::app {
namespace {

std::vector<Bounds> boxAt(double low) {
    Bounds box;
    box.add(Vec3(0, low, 0));
    box.add(Vec3(1, low + 1, 1));
    return {box};
}

TEST(ImpactWatch, SeesEachFallOnce) {
    ImpactWatch watch;
    int impacts = 0;
    for (const double height : {0.0, 0.0, 0.5, 0.2, 0.001, 0.0, 0.0, 0.3, 0.0}) {
        impacts += watch.see(boxAt(height), 0.0, 1.7) ? 1 : 0;
    }
    EXPECT_EQ(impacts, 2) << "resting on the floor is none, and neither is starting there";
}

TEST(ImpactWatch, WithoutAFloorThereIsNone) {
    ImpactWatch watch;
    EXPECT_FALSE(watch.see(boxAt(3), std::nullopt, 1.7));
    EXPECT_FALSE(watch.see(boxAt(-3), std::nullopt, 1.7));
}

TEST(ImpactWatch, NewPiecesAreFollowedToo) {
    ImpactWatch watch;
    std::vector<Bounds> two = boxAt(1);
    two.push_back(two[0]);
    EXPECT_FALSE(watch.see(boxAt(1), 0.0, 1.7));
    EXPECT_FALSE(watch.see(two, 0.0, 1.7));
    two[1] = boxAt(0)[0];
    EXPECT_TRUE(watch.see(two, 0.0, 1.7));
}

class EditorReadingsTest : public test::GlTest {};

/// Whenever the times of a step are known, and whatever time stood still.
TEST_F(EditorReadingsTest, WhatNoStageCountsIsTheRestOfTheFrames) {
    Simulation simulation(test::cubeSphere(4, 0.5), Params{});
    EditorReadings readings;
    double stages = 0;
    const auto step = [&] {
        simulation.step();
        stages += simulation.report().times.sum();
        readings.addStep(simulation.report().time, simulation);
    };
    step();
    readings.addPicture(simulation.report().time, {}, 500);
    stages = 0;
    step();
    step();
    readings.addPicture(simulation.report().time, {60, 40}, 3);
    const ui::History& history = readings.history();
    EXPECT_EQ(history[ui::Reading::otherMs].buckets().size(), 1U);
    EXPECT_NEAR(history[ui::Reading::otherMs].last(), 40'000 - stages, 1e-6);
    EXPECT_NEAR(history[ui::Reading::windowMs].last(), 20'000 - 3, 1e-6);
    step();
    readings.addPicture(simulation.report().time, {1e-9, 1e-9}, 3);
    EXPECT_EQ(history[ui::Reading::otherMs].min(), 0) << "a timer of the driver may tell more";
}

/// Simulated seconds over seconds of the clock, but not across a jump in time.
TEST_F(EditorReadingsTest, TheRealTimeFactorIsOfWhatTheClockSaw) {
    Params params;
    params.iterations = 4;
    Simulation simulation(test::cubeSphere(4, 0.5), params);
    EditorReadings readings;
    EXPECT_FALSE(readings.realTimeFactor());
    const auto picture = [&](int steps, double seconds) {
        for (int i = 0; i < steps; ++i) {
            simulation.step();
            readings.addStep(simulation.report().time, simulation);
        }
        readings.addPicture(simulation.report().time, {seconds, seconds}, 0);
    };
    picture(1, 0);
    EXPECT_FALSE(readings.realTimeFactor());
    picture(4, 0.1);
    const ui::Series& factor = readings.history()[ui::Reading::realTimeFactor];
    EXPECT_NEAR(factor.last(), 4 * params.timeStep / 0.1, 1e-9);
    EXPECT_NEAR(*readings.realTimeFactor(), factor.last(), 1e-9);
    picture(4, 0.2);
    EXPECT_NEAR(factor.last(), 4 * params.timeStep / 0.2, 1e-9);
    EXPECT_GT(*readings.realTimeFactor(), factor.last())
        << "it takes a new pace up within a second";
    readings.addJump(0, simulation);
    const double before = *readings.realTimeFactor();
    picture(0, 0.1);
    EXPECT_EQ(readings.realTimeFactor(), before);
}

TEST_F(EditorReadingsTest, FollowsABodyThatFalls) {
    Params params;
    params.floor = -0.7;
    params.iterations = 4;
    Simulation simulation(test::cubeSphere(4, 0.5), params);
    EditorReadings readings;
    EXPECT_FALSE(readings.figures().has_value());
    for (int i = 0; i < 60; ++i) {
        simulation.step();
        readings.addStep(simulation.report().time, simulation);
        readings.addPicture(simulation.report().time, {0.02, 0.01}, 3);
    }
    const ui::History& history = readings.history();
    EXPECT_EQ(history[ui::Reading::volumePercent].buckets().size(), 60U);
    ASSERT_EQ(history.piecePercent.size(), 1U);
    EXPECT_NEAR(history.piecePercent[0].last(), history[ui::Reading::volumePercent].last(), 0.01);
    EXPECT_GT(history[ui::Reading::kineticEnergy].max(), 0);
    EXPECT_LT(history[ui::Reading::potentialEnergy].last(),
              history[ui::Reading::potentialEnergy].buckets().front().low);
    EXPECT_EQ(history[ui::Reading::renderMs].mean(), 3);
    EXPECT_GE(history[ui::Reading::otherMs].min(), 0);
    ASSERT_EQ(history.marks.size(), 1U);
    EXPECT_EQ(history.marks[0].label, "impact");
    ASSERT_TRUE(readings.figures().has_value());
    EXPECT_NEAR(readings.figures()->fps, 50, 1e-9);
    readings.forgetAfter(0.1);
    EXPECT_LE(history[ui::Reading::volumePercent].buckets().back().x, 0.1);
    EXPECT_TRUE(history.marks.empty()) << "the impact came later";
}

TEST_F(EditorReadingsTest, CountsThePiecesThatWereTakenBack) {
    Params params;
    params.gravity = Vec3::Zero();
    params.floor.reset();
    Simulation simulation(test::icosphere(1), params);
    EditorReadings readings;
    const auto stepOnce = [&] {
        simulation.step();
        readings.addStep(simulation.report().time, simulation);
    };
    const ui::History& history = readings.history();
    stepOnce();
    EXPECT_EQ(history[ui::Reading::lostPieces].last(), 0);
    // To a speed that nothing real reaches.
    ASSERT_EQ(simulation.execute(ApplyForce{Ball{{0.5, 0, 0}, 0.3}, Vec3(1e12, 0, 0)}), "");
    stepOnce();
    stepOnce();
    EXPECT_EQ(history[ui::Reading::lostPieces].last(), 2);
    ASSERT_EQ(simulation.execute(ApplyForce{Ball{{0.5, 0, 0}, 0.3}, Vec3::Zero()}), "");
    stepOnce();
    EXPECT_EQ(history[ui::Reading::lostPieces].last(), 2) << "since the start";
    readings.forgetAfter(2.5 * params.timeStep);
    EXPECT_EQ(history[ui::Reading::lostPieces].last(), 1) << "as of then";
}

TEST(FormatPlots, HasARowPerValue) {
    ui::Series series;
    series.add(0, 1.5);
    series.add(0.25, 2);
    ui::PlotSpec plot;
    plot.id = "volume";
    plot.curves = {{.label = "volume", .series = &series}};
    EXPECT_EQ(formatPlots(std::span(&plot, 1)),
              "plot,curve,time,mean,min,max,values\n"
              "volume,volume,0,1.5,1.5,1.5,1\n"
              "volume,volume,0.25,2,2,2,1\n");
}

}  // namespace
}  // namespace kerf::app
