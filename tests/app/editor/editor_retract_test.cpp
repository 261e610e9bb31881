// Hooks that hold a cut open, and the hand that takes one lip.

namespace kerf::app {
namespace {

const Vec2 kViewMiddle(kWidth / 2.0, kHeight / 2.0);
const Vec2 kBeside = kViewMiddle + Vec2(20, 0);

class EditorRetractTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        frames(1);
        click("blade.through");
        drag(kTop, kBottom, 10);  // a slit down the ball's front
        settle();
        ASSERT_EQ(editor->scene()->simulation().report().pieces, 1);
        changes_ = panels().changes.done;
        tap(Key::y, 1);
    }
    EditorScene& scene() { return *editor->scene(); }
    std::size_t changesSince() { return panels().changes.done - changes_; }
    /// How far the copies of points of the rim near the middle of the view stand apart [m].
    double gap() {
        const SurfaceMesh& mesh = scene().simulation().mesh();
        double widest = 0;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const Vec3& at = mesh.restPosition(v);
            if (mesh.copyGroup(v) < 0 || std::abs(at.y()) > 0.15 || at.z() < 0.45) {
                continue;
            }
            for (const int copy : mesh.copiesOfGroup(mesh.copyGroup(v))) {
                widest = std::max(widest, (mesh.position(copy) - mesh.position(v)).norm());
            }
        }
        return widest;
    }
    /// Hooks the lips at kBeside and draws them apart by this way of the pointer.
    void retract(const Vec2& way) {
        moveTo(kBeside);
        press(true, 2);
        for (int i = 1; i <= 10; ++i) {
            moveTo(kBeside.x() + way.x() * i / 10, kBeside.y() + way.y() * i / 10, 1);
        }
        release();
    }
    void clickRight(const Vec2& at) {
        moveTo(at);
        press(true, Button::right);
        press(false, Button::right);
        settle();
    }
    Vec2 pixelOfHook(std::size_t index) {
        const ui::PlotPoint at = panels().view.overlay.handles.at(index).at;
        return {at.x, at.y};
    }

    std::size_t changes_ = 0;
};

TEST_F(EditorRetractTest, ADragBesideACutHoldsItOpen) {
    EXPECT_LT(gap(), 0.01);
    moveTo(kBeside, 2);
    EXPECT_EQ(panels().view.overlay.dots.size(), 2U) << "the lips that it would hook";
    EXPECT_EQ(editor->cursor(), ui::Cursor::hand);
    retract(Vec2(60, 0));
    const double opened = gap();
    EXPECT_GT(opened, 0.1);
    EXPECT_EQ(panels().body.hooks, 2U);
    EXPECT_EQ(panels().view.overlay.handles.size(), 2U);
    EXPECT_EQ(changesSince(), 1U);
    EXPECT_EQ(panels().changes.rows.back().name, "Hold open");
    playFor(20);
    settle();
    EXPECT_NEAR(gap(), opened, 0.15 * opened) << "the hooks stay";
}

TEST_F(EditorRetractTest, AFlickOpensAsFarAsASlowDrag) {
    dragAndSettle(kBeside, kBeside + Vec2(60, 0), 3);
    EXPECT_GT(gap(), 0.1);
}

TEST_F(EditorRetractTest, ARightClickOnAHookRemovesTheRetractorAndTheCutCloses) {
    retract(Vec2(60, 0));
    const double opened = gap();
    clickRight(kViewMiddle + Vec2(0, 200));
    EXPECT_EQ(panels().body.hooks, 2U) << "a click elsewhere does nothing";
    clickRight(pixelOfHook(0));
    EXPECT_EQ(panels().body.hooks, 0U);
    EXPECT_LT(gap(), 0.5 * opened);
}

TEST_F(EditorRetractTest, DeleteRemovesTheLastRetractor) {
    retract(Vec2(40, 0));
    moveTo(kWidth / 2.0, 5);
    tap(Key::del);
    settle();
    EXPECT_EQ(panels().body.hooks, 0U);
}

TEST_F(EditorRetractTest, AHookThatIsDraggedAgainMovesItsRetractorOn) {
    retract(Vec2(40, 0));
    const double before = gap();
    const Vec2 hook = pixelOfHook(0);
    const Vec2 away = (hook - pixelOfHook(1)).normalized();
    dragAndSettle(hook, hook + 20 * away, 4);
    EXPECT_GT(gap(), before + 0.03);
    EXPECT_EQ(panels().body.hooks, 2U);
}

TEST_F(EditorRetractTest, UndoTakesTheHooksBackAndRedoBringsThem) {
    const std::string before = scene().simulation().stateHash();
    retract(Vec2(60, 0));
    undo();
    EXPECT_EQ(panels().body.hooks, 0U);
    EXPECT_EQ(scene().simulation().stateHash(), before);
    editor->post(ui::KeyChange{Key::y, true, {.control = true}});
    settle();
    EXPECT_EQ(panels().body.hooks, 2U);
}

// Undo took the retractor back that had been removed already, and redo brought nothing.
TEST_F(EditorRetractTest, UndoBringsARemovedRetractorBack) {
    retract(Vec2(60, 0));
    const Vec2 hook = pixelOfHook(1);
    moveTo(hook);
    tap(Key::del);
    settle();
    EXPECT_EQ(panels().body.hooks, 0U);
    for (int round = 0; round < 2; ++round) {
        undo();
        EXPECT_EQ(panels().body.hooks, 2U);
        editor->post(ui::KeyChange{Key::y, true, {.control = true}});
        settle();
        EXPECT_EQ(panels().body.hooks, 0U);
    }
    EXPECT_EQ(changesSince(), 2U);
}

TEST_F(EditorRetractTest, HooksStayWhereSomethingElseIsUndone) {
    retract(Vec2(60, 0));
    tap(Key::v);
    undo();
    EXPECT_EQ(panels().body.hooks, 2U);
}

TEST_F(EditorRetractTest, EscTakesANewRetractorAway) {
    moveTo(kBeside);
    press(true, 2);
    moveTo(kBeside.x() + 50, kBeside.y(), 4);
    EXPECT_EQ(panels().view.overlay.labels.size(), 1U) << "how far they stand apart";
    tap(Key::escape);
    release();
    EXPECT_EQ(panels().body.hooks, 0U);
}

TEST_F(EditorRetractTest, ItIsRecordedAndReplaysToTheSameBits) {
    retract(Vec2(60, 10));
    clickRight(pixelOfHook(1));
    saveByKeys();
    expectReplayed(readSession(onlyFile(folder.path())), sphereDocument().mesh);
}

TEST_F(EditorRetractTest, APressFarFromEachCutSaysSoAndChangesNothing) {
    tap(Key::digit3);  // from the right
    settle();
    moveTo(kViewMiddle.x() + 100, kViewMiddle.y());
    press(true);
    release();
    EXPECT_THAT(panels().toast.text, HasSubstr("There is no cut nearby"));
    EXPECT_EQ(changesSince(), 0U);
    EXPECT_EQ(panels().body.hooks, 0U);
}

TEST_F(EditorRetractTest, TheHandTakesOneLip) {
    tap(Key::d);
    moveTo(kBeside);
    press(true, 2);
    const SurfaceMesh& mesh = scene().simulation().mesh();
    const auto& held = scene().simulation().hands().at(0).held;
    EXPECT_GT(held.size(), 4U);
    std::set<int> groups;
    for (const Hands::Held& each : held) {
        const int group = mesh.copyGroup(each.vertex);
        EXPECT_TRUE(group < 0 || groups.insert(group).second) << "both sides of the cut";
        EXPECT_GT(mesh.restPosition(each.vertex).x(), -0.01);
    }
    moveTo(kBeside.x() + 60, kBeside.y(), 20);
    EXPECT_GT(gap(), 0.03) << "it opens";
    release();
}

}  // namespace
}  // namespace kerf::app
