// Steps and iterations that follow the clock, whose times are made up here.
#include "app/editor/steps/pace_keeper.h"

#include "app/cli/replay/replay.h"
#include "app/scene/document/document_loading.h"
#include "app/scene/editor_scene.h"
#include "app/scene/readout/scene_readout.h"
#include "app/scene/timeline/scene_recorder.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/session.h"
#include "sim/body/body_model.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"
#include "ui/state/panel_model.h"

namespace kerf::app {
namespace {

Params firmParams() {
    Params params = ofNewScene(Params{});
    params.timeStep = 0.002;
    params.youngsModulus = 3e5;
    params.floor.reset();
    params.sleeps = 0;
    return params;
}

TEST(KeepingPace, TakesTheFinestDivisionThatKeepsUp) {
    const Params accurate = firmParams();
    const SweepStrength sweeps(buildBodyModel(test::cubeSphere(6, 0.05)), accurate);
    const StepDivision coarsest{0.01, kFewestPaced};
    EXPECT_EQ(keepingPace(sweeps, accurate, {1, 1}), coarsest) << "nothing keeps up";
    Params fine = accurate;
    double before = 1e9;
    for (const double each : {1e-3, 3e-4, 1e-4, 1e-5, 1e-7}) {
        const StepCost cost{0, each};
        const StepDivision steps = keepingPace(sweeps, accurate, cost);
        EXPECT_TRUE(cost.factor(steps) >= 1 || steps == coarsest) << each;
        fine.timeStep = steps.timeStep;
        fine.iterations = steps.iterations;
        EXPECT_LE(sweeps.error(fine), before) << each;
        before = sweeps.error(fine);
    }
    EXPECT_EQ(fine.timeStep, accurate.timeStep);
    EXPECT_EQ(fine.iterations, sweeps.iterationsFor(accurate, 0)) << "no finer than accurate";
}

class PaceKeeperTest : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        Document document = sphereDocument();
        document.session.params = firmParams();
        UploadedDocument uploaded(prepareDocument(std::move(document)));
        scene.emplace(std::move(uploaded.document), std::move(uploaded.body));
        describe();
    }
    /// So many pictures of a step each, which takes so long.
    void pictures(int count, double seconds) {
        for (int i = 0; i < count; ++i) {
            scene->timeline().playing = true;
            scene->step();
            describe();
            keeper.follow(*scene, {seconds, seconds});
        }
    }
    void describe() {
        ui::PanelModel model;
        scene->describe(model);
    }
    const Params& params() { return scene->simulation().params(); }

    std::optional<EditorScene> scene;
    PaceKeeper keeper;
};

TEST_F(PaceKeeperTest, SetsWhatASceneIsSolvedByAndGivesItBack) {
    pictures(3, 0.3);
    EXPECT_EQ(params(), firmParams()) << "it is off";
    keeper.toggle(*scene);
    pictures(1, 0.3);
    EXPECT_EQ(params().timeStep, 0.01);
    EXPECT_EQ(params().iterations, kFewestPaced);
    EXPECT_NE(keeper.cost(scene->readout().sweeps(), params()), "");
    pictures(12, 0.3);
    EXPECT_EQ(params().iterations, kFewestPaced) << "there is nothing coarser";
    pictures(1100, 1e-3);
    const StepDivision finer{params().timeStep, params().iterations};
    EXPECT_TRUE(finer.timeStep < 0.01 || finer.iterations > kFewestPaced) << "there is time";
    keeper.toggle(*scene);
    EXPECT_EQ(params(), firmParams());
    EXPECT_EQ(keeper.cost(scene->readout().sweeps(), params()), "");
}

TEST_F(PaceKeeperTest, APersonWhoSetsTheStepsEndsIt) {
    keeper.toggle(*scene);
    pictures(2, 0.3);
    scene->execute(SetParam{"iterations", 30.0});
    pictures(1, 0.3);
    EXPECT_FALSE(keeper.isOn());
    EXPECT_EQ(params().iterations, 30);
    EXPECT_EQ(params().timeStep, firmParams().timeStep) << "which nobody set";
}

TEST_F(PaceKeeperTest, AnUndoEndsItAndBringsBothBack) {
    pictures(1, 0.3);
    keeper.toggle(*scene);
    pictures(2, 0.3);
    scene->execute(Undo{});
    pictures(1, 0.3);
    EXPECT_FALSE(keeper.isOn());
    EXPECT_EQ(params(), firmParams());
}

/// A replay needs no clock.
TEST_F(PaceKeeperTest, WhatItChoseIsReplayedToTheSameBits) {
    pictures(2, 0.3);
    keeper.toggle(*scene);
    pictures(8, 0.3);
    pictures(1100, 1e-3);
    const Session saved =
        scene->recorder().savedSession({}, scene->document().session.colors).session;
    EXPECT_TRUE(std::ranges::any_of(saved.events, [](const SessionEvent& event) {
        const auto* set = std::get_if<SetParam>(&event.action);
        return set != nullptr && set->name == "time_step";
    }));
    const test::TemporaryFolder folder;
    const ReplayResult again = replaySession(saved, sphereDocument().mesh, folder / "out", {}, {});
    EXPECT_EQ(again.summary.stateHash, scene->simulation().stateHash());
}

}  // namespace
}  // namespace kerf::app
