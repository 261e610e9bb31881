#include "app/scene/readout/editor_readings.h"

#include "app/editor/storage/file_saving.h"
#include "app/scene/document/triangle_text.h"
#include "app/scene/readout/cut_quality.h"
#include "app/scene/readout/surface_look.h"
#include "app/session/cut_report.h"

namespace kerf::app {
namespace {

std::vector<Bounds> boxAt(double low) {
    Bounds box{Vec3(0, low, 0), Vec3(1, low + 1, 1)};
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

class EditorReadingsTest : public GlTest {};

/// Whenever the times of a step are known, and whatever time stood still.
TEST_F(EditorReadingsTest, WhatNoStageCountsIsTheRestOfTheFrames) {
    Simulation simulation(cubeSphere(4, 0.5), Params{});
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
    Simulation simulation(cubeSphere(4, 0.5), params);
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
    Simulation simulation(cubeSphere(4, 0.5), params);
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
    Simulation simulation(icosphere(1), params);
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

// What is under the pointer while the body moves: the same as of the whole mesh, without reading
// it.

constexpr int kSteps = 12;

/// Falls, and is cut in the first steps.
class SurfaceLookTest : public GlTest {
  protected:
    static Simulation falling() { return Simulation(cubeSphere(12), Params{}); }
    static void step(Simulation& simulation, int i) {
        const Vec3 middle(0, 0.6 - 0.05 * i, 0.03);
        simulation.execute(MoveBlade{{middle - Vec3(0.8, 0, 0), middle + Vec3(0.8, 0, 0)}});
        simulation.step();
    }
    static render::Ray rayAt(double x, double y) { return {Vec3(x, y, 3), -Vec3::UnitZ()}; }
    static std::vector<Blade> wayAt(double y) {
        return {{Vec3(-0.7, y, 0.1), Vec3(0.7, y, 0.1)},
                {Vec3(-0.7, y - 0.3, 0.1), Vec3(0.7, y - 0.3, 0.1)}};
    }
};

TEST_F(SurfaceLookTest, FindsWhatTheWholeMeshHasWithoutReadingIt) {
    Simulation looked = falling();
    Simulation whole = falling();
    SurfaceLook look;
    int hits = 0;
    for (int i = 0; i < kSteps; ++i) {
        step(looked, i);
        step(whole, i);
        const int before = looked.wholeReads();
        for (const double x : {-0.3, 0.02, 0.24, 0.6}) {
            const auto found = look.pick(looked, rayAt(x, 0.1));
            const auto wanted =
                pickSurface(whole.mesh(), livingTriangles(whole.mesh()), rayAt(x, 0.1));
            ASSERT_EQ(found.has_value(), wanted.has_value()) << "step " << i << ", x " << x;
            if (wanted) {
                ++hits;
                EXPECT_EQ(found->triangle, wanted->triangle);
                EXPECT_EQ(found->position, wanted->position);
                EXPECT_EQ(found->normal, wanted->normal);
            }
        }
        const CutPreview& found = look.preview(looked, wayAt(0.3));
        const CutPreview wanted =
            previewCut(whole.mesh(), livingTriangles(whole.mesh()), wayAt(0.3));
        EXPECT_EQ(found.touched, wanted.touched) << "step " << i;
        EXPECT_EQ(found.wound, wanted.wound) << "step " << i;
        EXPECT_FALSE(wanted.touched.empty());
        EXPECT_EQ(looked.wholeReads(), before) << "step " << i;
    }
    EXPECT_GT(hits, 2 * kSteps);
    EXPECT_EQ(looked.stateHash(), whole.stateHash()) << "to look changes nothing";
}

TEST_F(SurfaceLookTest, NoWayTouchesNothing) {
    Simulation simulation = falling();
    SurfaceLook look;
    EXPECT_TRUE(look.preview(simulation, {}).touched.empty());
}

std::string ofAll(const CutReport& report, const std::string& quantity) {
    for (const ui::CutRow& row : rowsOf(report)) {
        if (row.quantity == quantity) {
            return row.all;
        }
    }
    ADD_FAILURE() << "no row about " << quantity;
    return "";
}

CutReport reportWith(const ShapeFigures& walls) {
    CutReport report;
    report.all.walls = walls;
    report.strokes.push_back(report.all);
    return report;
}

TEST(CutQuality, AnglesAreToldWhereThereAreTriangles) {
    ShapeFigures walls;
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, worst"), "-");
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, mean"), "-");
    walls.triangles = 2;
    walls.worstAngle = 12.34;
    walls.angleSum = 60;
    EXPECT_EQ(ofAll(reportWith(walls), "Triangles"), "2");
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, worst"), "12.3\u00b0");
    EXPECT_EQ(ofAll(reportWith(walls), "Minimum angle, mean"), "30.0\u00b0");
}

TEST(TriangleText, TellsNeedlesWhereThereAreSome) {
    TriangleFigures figures = figuresOf(boxSoup(Vec3(1, 20, 1)));
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles, 8 slivers; edge length "));
    figures.needles = 1;
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles, 1 sliver; edge length "));
    figures.needles = 0;
    EXPECT_THAT(trianglesText(figures), StartsWith("12 triangles; edge length "));
}

}  // namespace
}  // namespace kerf::app
