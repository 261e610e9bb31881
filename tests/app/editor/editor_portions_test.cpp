// Steps that are done in portions, with pictures and input in their midst.

namespace kerf::app {
namespace {

using namespace testing;

/// An editor by the clock that makes a picture at every pause of a step.
class EditorPortionsTest : public EditorTest {
  protected:
    EditorOptions options() override {
        EditorOptions options = EditorTest::options();
        options.byTheClock = options.drawsAll = true;
        options.portion = 0;
        return options;
    }
    void show(Document document) { start(options(), std::move(document)); }
    /// Turns the view on and on, so that each picture draws the scene.
    void turningFrames(int count) {
        moveTo(kWidth / 2.0, kHeight / 2.0);
        press(true, Button::right);
        for (int i = 0; i < count; ++i) {
            moveTo(kWidth / 2.0 + i % 40, kHeight / 2.0, 1);
        }
        press(false, Button::right);
        frames(1);
    }
    /// Frames until nothing is left to be cut.
    void untilCut() {
        for (int i = 0; i < 20000 && editor->scene()->stroke().pending() > 0; ++i) {
            frames(1);
        }
    }
};

/// A replay that writes nothing.
struct Executing {
    Simulation& simulation;
    void perform(const Command& command, int /*number*/) { simulation.execute(command); }
    template <class Event>
    void take(const Event& /*event*/) {}
};

/// The state after all steps of a session that nobody watches.
std::string hashAfter(const Session& session, const Document& start) {
    Simulation simulation(start.mesh, session.params, session.boxes);
    simulation.setUndoBudget(kReplayUndoBudget);
    SimulationDriver driver(simulation);
    const SessionSchedule schedule(session);
    Executing host{simulation};
    while (simulation.stepCount() < session.steps) {
        driver.applyActions(schedule, host);
        driver.step();
    }
    driver.applyActions(schedule, host);
    return simulation.stateHash();
}

TEST_F(EditorPortionsTest, PicturesInTheMidstOfStepsChangeNoBit) {
    tap(Key::v);  // gravity
    tap(Key::space);
    turningFrames(40);
    drag(kTop, kBottom, 12);
    turningFrames(80);
    untilCut();
    turningFrames(40);
    tap(Key::space);
    EditorScene& scene = *editor->scene();
    ASSERT_GT(scene.simulation().stepCount(), 20);
    const Session session = scene.recorder().savedSession({}, {}).session;
    EXPECT_EQ(hashAfter(session, sphereDocument()), scene.simulation().stateHash());
}

TEST_F(EditorPortionsTest, AStepOfALargeBodyTakesSeveralPicturesThatHeedThePointer) {
    Document large = sphereDocument();
    large.mesh = cubeSphere(40, 0.5);
    show(std::move(large));
    tap(Key::space, 1);
    const int before = editor->scene()->simulation().stepCount();
    const Vec3 axis = editor->panels().view.axes.axes[0];
    moveTo(kWidth / 2.0, kHeight / 2.0);
    press(true, Button::right);
    for (int i = 1; i <= 10; ++i) {
        moveTo(kWidth / 2.0 + 5 * i, kHeight / 2.0, 1);
    }
    press(false, Button::right);
    EXPECT_NE(editor->panels().view.axes.axes[0], axis) << "the view has turned";
    EXPECT_LE(editor->scene()->simulation().stepCount(), before + 2)
        << "ten pictures were no ten steps";
}

/// The last picture before a step ends shows what the one before it drew.
TEST_F(EditorPortionsTest, TheTimesOfAStepCountAllPicturesSinceTheLastOne) {
    Document large = sphereDocument();
    large.mesh = cubeSphere(40, 0.5);
    show(std::move(large));
    tap(Key::space);
    const ui::History& history = *editor->panels().plots.history;
    const auto measured = [&] { return history[ui::Reading::frameMs].buckets().size(); };
    for (int i = 0; i < 20000 && measured() < 3; ++i) {
        frames(1);
    }
    ASSERT_GE(measured(), 3U);
    EXPECT_GT(history[ui::Reading::renderMs].mean(), 0);
}

TEST_F(EditorPortionsTest, WhatIsAskedForInTheMidstOfAStepIsDoneAfterIt) {
    tap(Key::space, 2);
    tap(Key::v);  // in the midst of a step
    tap(Key::space, 400);
    EXPECT_GT(editor->scene()->simulation().params().gravity.norm(), 0);
    EXPECT_FALSE(editor->scene()->timeline().playing);
}

TEST_F(EditorPortionsTest, AHandIsAheadOfABodyInSlowMotionWhichIsTold) {
    Document slow = sphereDocument();
    slow.session.params.timeStep = 0.0005;
    show(std::move(slow));
    tap(Key::d);
    moveTo(kWidth / 2.0, kHeight / 2.0, 1);
    press(true, 1);
    moveTo(kWidth / 2.0 + 150, kHeight / 2.0);
    for (int i = 0; i < 400 && editor->scene()->simulation().hands().empty(); ++i) {
        frames(1);
    }
    const std::string told = "The body follows in slow motion: the hand is";
    for (int i = 0; i < 40 && !panels().help.hint.text.starts_with(told); ++i) {
        frames(1);
    }
    EXPECT_THAT(panels().help.hint.text, HasSubstr(told));
    press(false, 1);
    EXPECT_FALSE(editor->scene()->simulation().hands().empty()) << "it lets go where it was led to";
    for (int i = 0; i < 20000 && !editor->scene()->simulation().hands().empty(); ++i) {
        frames(1);
    }
    EXPECT_TRUE(editor->scene()->simulation().hands().empty());
}

/// The scene is not to be touched then by a tool that holds nothing.
TEST_F(EditorPortionsTest, EscInTheMidstOfAStepNeedsNoHand) {
    tap(Key::d);
    tap(Key::space);
    for (int i = 0; i < 30; ++i) {
        frames(1);
        tap(Key::escape);
    }
    EXPECT_GT(editor->scene()->simulation().stepCount(), 0);
}

/// Its steps are not drawn one by one, so none of them is waited for.
TEST_F(EditorPortionsTest, ASeekArrives) {
    tap(Key::space);
    for (int i = 0; i < 20000 && editor->scene()->simulation().stepCount() < 12; ++i) {
        frames(1);
    }
    tap(Key::space);
    settle();
    const int last = editor->scene()->simulation().stepCount();
    editor->scene()->seek(0);
    for (const int target : {last / 2, last}) {
        editor->scene()->seek(target);
        for (int i = 0; i < 20000 && editor->scene()->timeline().seekSteps() > 0; ++i) {
            frames(1);
        }
        EXPECT_EQ(editor->scene()->simulation().stepCount(), target);
    }
}

TEST_F(EditorPortionsTest, AHiddenWindowIsNotDrawn) {
    const auto picture = [&] { return editor->readPicture().pixels; };
    const auto before = picture();
    editor->hide(true);
    tap(Key::digit7, 30);
    EXPECT_EQ(picture(), before);
    editor->hide(false);
    frames(30);
    EXPECT_NE(picture(), before) << "the view is another one";
}

TEST_F(EditorPortionsTest, AnotherDocumentTakesThePlaceOfAStepThatIsUnderWay) {
    tap(Key::space, 3);
    open(gpu::dataPath("assets/sessions/drop-in.kerf.json"));
    EXPECT_EQ(editor->title(), "Kerf - drop-in - 1 piece");
    EXPECT_EQ(editor->scene()->simulation().stepCount(), 0);
}

TEST_F(EditorPortionsTest, IsClosedInTheMidstOfAStep) {
    tap(Key::space, 3);
    editor.reset();
}

}  // namespace
}  // namespace kerf::app
