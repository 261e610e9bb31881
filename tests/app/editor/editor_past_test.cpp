// Going back in time by the time line, and on from there.

namespace kerf::app {
namespace {

class EditorPastTest : public EditorTest {
  protected:
    EditorScene& scene() { return *editor->scene(); }
    int step() { return scene().simulation().stepCount(); }
    std::string hash() { return scene().simulation().stateHash(); }
    int pieces() { return scene().simulation().report().pieces; }
    void goTo(int wanted) {
        scene().seek(wanted);
        settle(1);
    }
    void playFor(int pictures) {
        tap(Key::space);
        frames(pictures);
        tap(Key::space, 1);
    }
    /// In two halves, which fall.
    void cutAndLetFall() {
        dragAndSettle(kTop, kBottom, 10);
        tap(Key::space, {.shift = true}, 25);
        tap(Key::space);
        settle();
    }
    /// Half through, and still held.
    void beginStroke() {
        moveTo(kTop);
        press(true);
        for (int i = 1; i <= 6; ++i) {
            const Vec2 at = kTop + (kBottom - kTop) * (i / 10.0);
            moveTo(at, 1);
        }
        settle();
    }
    void dragTimeLineTo(double share) {
        const ui::Rect bar = editor->itemRects().at("scrubber");
        dragAndSettle(Vec2(bar.x + bar.width - 4, bar.y + bar.height / 2),
                      Vec2(bar.x + share * bar.width, bar.y + bar.height / 2), 3);
        frames(1);
    }
    /// What is saved, without a window.
    void expectItReplays() {
        const Document& document = scene().document();
        const Session session =
            scene().recorder().savedSession(document.camera, document.session.colors).session;
        const auto file = folder / "past.kerf.json";
        writeText(file, formatSession(session, folder.path()));
        EXPECT_EQ(replayedHash(readSession(file), {document.mesh, document.looks}), hash());
    }
};

TEST_F(EditorPastTest, EachMomentIsAsItWas) {
    dragAndSettle(kTop, kBottom, 10);
    playFor(20);
    const int between = step();
    const std::string then = hash();
    playFor(30);
    const int end = step();
    const std::string last = hash();
    ASSERT_EQ(pieces(), 2);
    goTo(0);
    EXPECT_EQ(step(), 0);
    EXPECT_EQ(pieces(), 1);
    EXPECT_TRUE(panels().session.playback.played);
    goTo(between);
    EXPECT_EQ(hash(), then);
    goTo(end);
    EXPECT_EQ(hash(), last);
    EXPECT_FALSE(panels().session.playback.played) << "the present again";
    expectItReplays();
    goTo(between);
    EXPECT_EQ(hash(), then);
}

TEST_F(EditorPastTest, ThePointerDragsTheTimeLineBack) {
    cutAndLetFall();
    const int end = step();
    dragTimeLineTo(0.02);
    EXPECT_LT(step(), end / 10);
    EXPECT_EQ(pieces(), 1);
    EXPECT_FALSE(panels().transport.playing);
    EXPECT_THAT(panels().help.hint.text, HasSubstr("You are viewing an earlier step"));
    EXPECT_EQ(panels().session.playback.steps, end) << "nothing is lost yet";
    tap(Key::space);
    frames(end);
    EXPECT_EQ(step(), end) << "at the present it stops";
    EXPECT_EQ(pieces(), 2);
}

TEST_F(EditorPastTest, AStrokeThereLeavesOutWhatCameAfter) {
    cutAndLetFall();
    const int end = step();
    goTo(3);
    ASSERT_EQ(pieces(), 1);
    dragAndSettle(kTop + Vec2(60, 0), kBottom + Vec2(60, 0), 10);
    EXPECT_EQ(pieces(), 2);
    EXPECT_LT(step(), end);
    EXPECT_FALSE(panels().session.playback.played);
    EXPECT_THAT(panels().toast.text, HasSubstr("was discarded"));
    expectItReplays();
    const int here = step();
    const std::string now = hash();
    playFor(10);
    ASSERT_GT(step(), here);
    goTo(here);
    EXPECT_EQ(hash(), now);
}

TEST_F(EditorPastTest, AParameterThatIsChangedThereGoesIntoWhatPlaysOn) {
    cutAndLetFall();
    const int end = step();
    const std::string last = hash();
    goTo(end / 2);
    ASSERT_EQ(scene().execute(SetParam{"youngs_modulus", 3e5}), "");
    goTo(end);
    EXPECT_NE(hash(), last);
    EXPECT_EQ(pieces(), 2);
    expectItReplays();
}

TEST_F(EditorPastTest, ItGoesBackBeyondARestart) {
    cutAndLetFall();
    const int fallen = step();
    const std::string then = hash();
    tap(Key::r);
    settle();
    playFor(10);
    const double restarted = panels().transport.time;
    EXPECT_LT(restarted, 12 * 0.005) << "counts from the restart";
    const int end = step();
    const std::string last = hash();
    goTo(fallen);
    EXPECT_EQ(hash(), then);
    EXPECT_EQ(panels().transport.step, fallen);
    EXPECT_GT(panels().transport.time, restarted);
    goTo(end);
    EXPECT_EQ(hash(), last);
    EXPECT_EQ(panels().transport.time, restarted);
}

TEST_F(EditorPastTest, ARestartThereLeavesOutWhatCameAfter) {
    cutAndLetFall();
    goTo(5);
    tap(Key::r);
    settle();
    EXPECT_EQ(pieces(), 1);
    EXPECT_FALSE(panels().session.playback.played);
    playFor(5);
    EXPECT_EQ(pieces(), 1) << "no stroke comes of itself";
    expectItReplays();
}

TEST_F(EditorPastTest, ABladeThatIsDownIsPutAway) {
    press(false);
    beginStroke();
    ASSERT_GT(step(), 2);
    const int end = step();
    goTo(1);
    press(false);
    goTo(end);
    EXPECT_FALSE(panels().session.playback.played);
    expectItReplays();
}

// The stroke was forgotten, and the blade stayed in the body.
TEST_F(EditorPastTest, ARedoOfNothingEndsTheStroke) {
    beginStroke();
    ASSERT_TRUE(scene().simulation().blade());
    tap(Key::y, {.control = true});
    EXPECT_EQ(panels().toast.text, "There is nothing to redo.");
    press(false);
    tap(Key::period);
    settle();
    EXPECT_FALSE(scene().simulation().blade());
    expectItReplays();
}

TEST_F(EditorPastTest, ABladeThatIsLiftedWhereAMomentIsKeptStaysLifted) {
    const int kept = 50;
    while (step() < kept - 2) {
        scene().step();
    }
    for (double y = 0.7; step() < kept; y = 0) {
        ASSERT_EQ(scene().execute(MoveBlade{{{-1, y, 0.01}, {1, y, 0.01}}}), "");
        scene().step();
    }
    ASSERT_EQ(scene().execute(LiftBlade{}), "");
    for (int i = 0; i < 5; ++i) {
        scene().step();
    }
    const int end = step();
    const std::string last = hash();
    goTo(kept);
    goTo(end);
    EXPECT_EQ(hash(), last);
}

TEST_F(EditorPastTest, ASessionThatAPersonWentOnWithGoesBackIntoItself) {
    writeText(folder / "slice.kerf.json", sliceSession(kLift));
    openAtStart(folder / "slice.kerf.json");
    goTo(50);
    dragAndSettle(kTop, kBottom, 10);
    const int end = step();
    const std::string last = hash();
    ASSERT_GT(pieces(), 2);
    goTo(20);
    EXPECT_EQ(pieces(), 1);
    goTo(end);
    EXPECT_EQ(hash(), last);
    goTo(45);
    dragAndSettle(kTop, kBottom, 10);
    expectItReplays();
    tap(Key::r);
    settle();
    goTo(60);
    EXPECT_EQ(pieces(), 2) << "from its start the session is whole again";
}

}  // namespace
}  // namespace kerf::app
