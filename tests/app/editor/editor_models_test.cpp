// The model's unit, axis, turn and scale in the editor.

namespace kerf::app {
namespace {

/// A box that stands on the ground of its own file, 9.66 high.
class EditorModelTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        TriangleSoup soup = boxSoup(Vec3(3, 9.66, 3), 9);  // not coarse
        for (Vec3& p : soup.positions) {
            p += Vec3(100, 4.83, 0);
        }
        writeText(folder / "figure.obj", objText(soup));
        editor->resize(1280, 1200);
        open(folder / "figure.obj", 2);
    }
    const ui::ModelState& model() { return panels().model.models[0]; }
    Simulation& simulation() { return editor->scene()->simulation(); }
    /// Where the middle of the body is in the picture, and how large it looks.
    Vec3 appearance() {
        const render::Camera camera = editor->scene()->rest().homeView();
        const Bounds& bounds = editor->scene()->rest().bounds();
        return (camera.eye - bounds.center()) / bounds.diagonal();
    }
    Bounds exportedBounds(const std::string& name, bool inScene) {
        tap(Key::e, {.control = true}, 2);
        type(name);
        if (inScene) {
            click("file.in_scene");
        }
        confirm();
        MeshReport report;
        loadModel(folder / name, &report);
        return report.bounds;
    }
};

TEST_F(EditorModelTest, OpensAsItIsAndSaysWhatWasTaken) {
    EXPECT_THAT(panels().toast.text, HasSubstr("assumed centimetres"));
    EXPECT_EQ(model().placement.scale, 1);
    EXPECT_EQ(model().placement.unit, LengthUnit::centimetre);
    EXPECT_NEAR(model().size.y(), 0.0966, 1e-6);
    EXPECT_THAT(model().physics, HasSubstr("Weighs 93 g at this size."));
    EXPECT_TRUE(panels().model.untouched);
    EXPECT_TRUE(editor->itemRects().contains("model.unit.m"));  // unfolded
}

TEST_F(EditorModelTest, AClickTakesAnotherUnitAndTheViewComesAlong) {
    const Vec3 before = appearance();
    click("model.unit.m");
    EXPECT_EQ(model().placement.unit, LengthUnit::metre);
    EXPECT_NEAR(model().size.y(), 9.66, 1e-4);
    EXPECT_THAT(model().physics, HasSubstr("It will collapse under its own weight"));
    EXPECT_TRUE(appearance().isApprox(before, 1e-4));
    EXPECT_NEAR(panels().tools.longest, 2 * editor->scene()->rest().bounds().diagonal(), 1e-6);
    tap(Key::z, {.control = true});
    EXPECT_EQ(model().placement.unit, LengthUnit::centimetre);
    EXPECT_TRUE(appearance().isApprox(before, 1e-4));
}

TEST_F(EditorModelTest, AnotherAxisLaysItDownOnTheFloor) {
    click("model.up.z");
    EXPECT_NEAR(model().size.z(), 0.0966, 1e-6);
    EXPECT_NEAR(model().size.y(), 0.03, 1e-6);
    const Bounds& bounds = editor->scene()->rest().bounds();
    EXPECT_NEAR(bounds.low.y(), 0.02 * bounds.diagonal(), 1e-6);
}

TEST_F(EditorModelTest, ExportsTheCoordinatesOfItsFileUnlessToldOtherwise) {
    const Bounds own = exportedBounds("own.obj", false);
    EXPECT_EQ(own.low.cast<float>(), Vec3(98.5, 0, -1.5).cast<float>());
    EXPECT_EQ(own.high.cast<float>(), Vec3(101.5, 9.66, 1.5).cast<float>());
    const Bounds scene = exportedBounds("scene.obj", true);
    EXPECT_NEAR(scene.high.y() - scene.low.y(), 0.0966, 1e-6);
    click("model.unit.in");
    editor->scene()->step();
    const Bounds moved = exportedBounds("inches.ply", false);
    EXPECT_NEAR(moved.high.y(), 9.66, 0.06);  // It fell for a step.
    EXPECT_NEAR(moved.high.x(), 101.5, 1e-3);
}

TEST_F(EditorModelTest, APlacementAfterACutStartsAnewAndIsReplayed) {
    const Document opened = openDocument(folder / "figure.obj");
    editor->resize(320, 240);
    dragAndSettle({160, 5}, {160, 235}, 6);
    ASSERT_EQ(editor->scene()->simulation().report().pieces, 2);
    EXPECT_FALSE(panels().model.untouched);
    const std::string cut = simulation().stateHash();
    Placement feet = model().placement;
    feet.unit = LengthUnit::foot;
    EXPECT_EQ(editor->scene()->place(feet, false), "");
    frames(2);
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 1);
    tap(Key::z, {.control = true});
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 2);
    EXPECT_EQ(simulation().stateHash(), cut);
    tap(Key::z, {.shift = true, .control = true});
    EXPECT_EQ(model().placement.unit, LengthUnit::foot);
    dragAndSettle({160, 5}, {160, 235}, 6);
    editor->scene()->recorder().addExport();
    const Session session =
        editor->scene()->recorder().savedSession(editor->scene()->rest().homeView(), {}).session;
    const Session again = parseSession(formatSession(session, folder.path()), folder.path());
    EXPECT_EQ(again.placement, opened.session.placement);
    ModelMesh model(opened.mesh, opened.looks);
    model.placed = opened.placed;
    expectReplayed(again, model);
}

TEST_F(EditorModelTest, ARecordingKeepsThePlacement) {
    click("model.unit.mm");
    const std::string hash = simulation().stateHash();
    editor->scene()->startRecording();
    frames(2);
    EXPECT_EQ(model().placement.unit, LengthUnit::millimetre);
    EXPECT_EQ(simulation().stateHash(), hash);
}

TEST_F(EditorModelTest, AnotherModelStandsBesideAndGoesAgain) {
    const TriangleSoup soup = boxSoup(Vec3(4, 2, 2), 2);
    writeText(folder / "stool.obj", objText(soup));
    const Bounds before = editor->scene()->rest().bounds();
    tap(Key::o, {.shift = true, .control = true}, 2);
    enter("stool.obj");
    frames(2);
    ASSERT_EQ(panels().model.models.size(), 2u);
    EXPECT_EQ(panels().model.models[1].name, "stool");
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 2);
    const std::vector<ModelFigures>& models = editor->scene()->rest().models();
    EXPECT_GT(models[1].bounds.low.x(), before.high.x());
    EXPECT_GT(models[1].bounds.low.y(), -1e-9);  // on the floor
    EXPECT_NEAR(models[1].volume, 16, 1e-9);
    click("model.1");
    click("model.unit.in");
    EXPECT_EQ(simulation().placement(1).unit, LengthUnit::inch);
    EXPECT_EQ(simulation().placement(0).unit, LengthUnit::centimetre);
    editor->scene()->step();
    editor->scene()->recorder().addExport();
    const Session session =
        editor->scene()->recorder().savedSession(editor->scene()->rest().homeView(), {}).session;
    expectReplayed(session, loadSessionModel(session));
    click("model.remove.1", 2);
    clickAndWait("question.1");
    frames(2);
    EXPECT_EQ(panels().model.models.size(), 1u);
    EXPECT_EQ(editor->scene()->simulation().report().pieces, 1);
    EXPECT_EQ(simulation().placement(0).unit, LengthUnit::centimetre);
}

TEST_F(EditorModelTest, AddsNoSession) {
    writeText(folder / "other.kerf.json", "{}");
    tap(Key::o, {.shift = true, .control = true}, 2);
    enter("other.kerf.json");
    EXPECT_THAT(panels().toast.text, HasSubstr("a session can't be added to a scene"));
    EXPECT_EQ(panels().model.models.size(), 1u);
}

// What was done so far is kept where the models of a scene change.

/// A box of a file.
class EditorModelsTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        write("box.obj", boxSoup(Vec3(3, 3, 3), 4));
        open(folder / "box.obj");
        settle();
        ASSERT_EQ(pieces(), 1);
    }
    void write(const std::string& name, const TriangleSoup& soup) {
        const auto file = folder / name;
        std::error_code none;
        const auto before = fs::last_write_time(file, none);
        writeText(file, objText(soup));
        if (!none) {  // by the clock it may be the same time
            fs::last_write_time(file, before + std::chrono::seconds(2));
        }
    }
    int pieces() { return editor->scene()->simulation().report().pieces; }
    int step() { return editor->scene()->simulation().stepCount(); }
    double volume() { return editor->scene()->rest().models()[0].volume; }
    /// With a blade along an axis, through the middle.
    void cut(const Vec3& along = Vec3::UnitY()) {
        EditorScene& scene = *editor->scene();
        const Bounds& box = scene.rest().bounds();
        const Vec3 half = 5 * box.diagonal() * along;
        for (const double z : {1.0, -1.0}) {
            const Vec3 at = box.center() + Vec3(0, 0, z * box.diagonal());
            ASSERT_EQ(scene.execute(MoveBlade{{at - half, at + half}}), "");
            scene.step();
        }
        ASSERT_EQ(scene.execute(LiftBlade{}), "");
        scene.step();
        frames(2);
        ASSERT_EQ(pieces(), 2);
    }
    void look(int times) {
        for (int i = 0; i < times; ++i) {
            editor->lookAtFiles();
            frames(1);
        }
    }
    void finish() {
        waitForWork();
        settle(1);
    }
    std::string changes() { return joined(panels().changes.rows, ", ", &ui::ChangeRow::name); }
    std::string hint() { return panels().help.hint.text; }
    void add(const std::string& file) {
        tap(Key::o, {.shift = true, .control = true}, 2);
        type(file);
        tap(Key::enter);
        finish();
    }
};

TEST_F(EditorModelsTest, AChangedFileIsReloadedWithItsCuts) {
    cut();
    const int end = step();
    look(3);
    EXPECT_THAT(hint(), Not(HasSubstr("changed on disk")));
    write("box.obj", boxSoup(Vec3(2.5, 3, 3), 5));
    look(1);
    EXPECT_THAT(hint(), Not(HasSubstr("changed on disk"))) << "may still be written";
    look(1);
    EXPECT_EQ(hint(), "box.obj has changed on disk. Reload it?");
    const double before = volume();
    click("hint.F5");
    finish();
    EXPECT_EQ(panels().toast.text, "Reloaded box.obj.");
    EXPECT_NE(volume(), before);
    EXPECT_EQ(pieces(), 2);
    EXPECT_EQ(step(), end);
    look(3);
    EXPECT_THAT(hint(), Not(HasSubstr("changed on disk")));
    for (int i = 0; i < 8 && volume() != before; ++i) {  // gravity may be among the changes
        tap(Key::z, {.control = true});
        settle();
    }
    EXPECT_EQ(volume(), before);
    EXPECT_EQ(pieces(), 2) << "the scene before, with its cut";
}

TEST_F(EditorModelsTest, AnIgnoredChangeIsOfferedNoMore) {
    write("box.obj", boxSoup(Vec3(2.5, 3, 3), 5));
    look(2);
    click("hint.Esc");
    look(3);
    EXPECT_THAT(hint(), Not(HasSubstr("changed on disk")));
    write("box.obj", boxSoup(Vec3(2.5, 3.2, 3), 5));
    look(2);
    EXPECT_EQ(hint(), "box.obj has changed on disk. Reload it?");
    tap(Key::escape);
    EXPECT_THAT(hint(), Not(HasSubstr("changed on disk")));
}

// Without a word the session was saved for another model, also after Ignore and after an undo.
TEST_F(EditorModelsTest, SavingTellsThatTheModelHasChanged) {
    cut();
    saveByKeys();
    EXPECT_THAT(panels().toast.text, Not(HasSubstr("has changed")));
    write("box.obj", boxSoup(Vec3(2.5, 3, 3), 5));
    look(2);
    click("hint.Esc");
    saveByKeys();
    EXPECT_THAT(panels().toast.text, HasSubstr("box.obj has changed since it was read; the "
                                               "saved session will use the new version."));
    tap(Key::f5);
    finish();
    saveByKeys();
    EXPECT_THAT(panels().toast.text, Not(HasSubstr("has changed")));
    for (int i = 0; i < 8 && panels().toast.text != "Undone: Reload"; ++i) {
        tap(Key::z, {.control = true});
        finish();
    }
    saveByKeys();
    EXPECT_THAT(panels().toast.text, HasSubstr("has changed since it was read"));
    fs::remove(folder / "box.obj");
    saveByKeys();
    EXPECT_THAT(panels().toast.text, HasSubstr("box.obj is gone; the saved session needs it."));
}

TEST_F(EditorModelsTest, CutsThatMissTheNewModelAreTold) {
    cut();
    TriangleSoup low = boxSoup(Vec3(3, 3, 3), 4);
    for (Vec3& p : low.positions) {
        p.x() += 20;
    }
    write("box.obj", low);
    look(2);
    click("hint.F5");
    finish();
    EXPECT_EQ(pieces(), 1);
    EXPECT_THAT(panels().toast.text, HasSubstr("The same cuts make 1 piece now, instead of 2."));
}

TEST_F(EditorModelsTest, AFileThatCantBeReadChangesNothing) {
    cut();
    writeText(folder / "box.obj", "no model at all");
    tap(Key::f5);
    finish();
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("box.obj"));
    fs::remove(folder / "box.obj");
    look(3);
    EXPECT_THAT(hint(), Not(HasSubstr("changed on disk")));
    EXPECT_EQ(pieces(), 2);
}

TEST_F(EditorModelsTest, AnUntouchedModelIsReloadedAndStaysSaved) {
    write("box.obj", boxSoup(Vec3(2.5, 3, 3), 5));
    tap(Key::f5);
    finish();
    editor->askToLeave();
    EXPECT_TRUE(editor->closing()) << panels().question.text;
}

TEST_F(EditorModelsTest, AddingAModelKeepsTheCuts) {
    write("stool.obj", boxSoup(Vec3(4, 2, 2), 2));
    cut();
    const int end = step();
    const std::string before = changes();
    add("stool.obj");
    EXPECT_THAT(panels().question.text, IsEmpty());
    EXPECT_THAT(panels().toast.text, HasSubstr("Added as model 1."));
    EXPECT_EQ(panels().model.models.size(), 2U);
    EXPECT_EQ(pieces(), 3);
    EXPECT_EQ(step(), end);
    EXPECT_EQ(changes(), before + ", Add model") << "what is repeated is listed once";
    EXPECT_EQ(panels().changes.done, panels().changes.rows.size());
    tap(Key::z, {.control = true});
    finish();
    EXPECT_EQ(panels().model.models.size(), 1U);
    EXPECT_EQ(changes(), before + ", Add model");
    EXPECT_EQ(panels().changes.done, panels().changes.rows.size() - 1);
    tap(Key::z, {.shift = true, .control = true});
    finish();
    EXPECT_EQ(panels().model.models.size(), 2U);
    EXPECT_EQ(pieces(), 3);
    editor->resize(1280, 1200);
    frames(2);
    click("model.remove.1");
    finish();
    EXPECT_EQ(panels().toast.text, "Removed stool.");
    EXPECT_EQ(panels().model.models.size(), 1U);
    EXPECT_EQ(pieces(), 2);
}

TEST_F(EditorModelsTest, AStrokeThatCutsAnAddedModelTooIsTold) {
    write("stool.obj", boxSoup(Vec3(3, 3, 3), 4));
    cut(Vec3::UnitX());
    add("stool.obj");
    EXPECT_EQ(pieces(), 4);
    EXPECT_THAT(panels().toast.text, HasSubstr("The same cuts make 4 pieces now, instead of 3."));
}

TEST_F(EditorModelsTest, RemovingIsAskedWhereWhatWasDoneIsAboutTheModel) {
    write("stool.obj", boxSoup(Vec3(4, 2, 2), 2));
    add("stool.obj");
    ASSERT_EQ(editor->scene()->execute(SetParam{"density@1", 500.0}), "");
    editor->resize(1280, 1200);
    frames(2);
    click("model.remove.1", 2);
    EXPECT_EQ(panels().question.title, "Removing stool resets the scene");
    EXPECT_THAT(panels().question.choices, ElementsAre("Save...", "Reset and remove", "Cancel"));
    click("question.1");
    finish();
    EXPECT_EQ(panels().model.models.size(), 1U);
}

}  // namespace
}  // namespace kerf::app
