// What was done so far is kept where the models of a scene change.
#include <gmock/gmock.h>

#include "app/scene/document/rest_of_body.h"
#include "app/scene/editor_scene.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/session.h"
#include "sim/base/text.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A box of a file.
class EditorModelsTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        write("box.obj", test::boxSoup(Vec3(3, 3, 3), 4));
        editor->open(folder / "box.obj");
        waitForWork();
        settle();
        ASSERT_EQ(pieces(), 1);
    }
    void write(const std::string& name, const TriangleSoup& soup) {
        const auto file = folder / name;
        std::error_code none;
        const auto before = std::filesystem::last_write_time(file, none);
        test::writeText(file, test::objText(soup));
        if (!none) {  // by the clock it may be the same time
            std::filesystem::last_write_time(file, before + std::chrono::seconds(2));
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
        settle();
        frames(1);
    }
    std::string changes() { return joined(panels().changes.rows, ", ", &ui::ChangeRow::name); }
    std::string hint() { return panels().help.hint.text; }
    void add(const std::string& file) {
        tap(Key::o, {.shift = true, .control = true});
        frames(2);
        type(file);
        tap(Key::enter);
        finish();
    }
};

TEST_F(EditorModelsTest, AChangedFileIsReloadedWithItsCuts) {
    cut();
    const int end = step();
    look(3);
    EXPECT_THAT(hint(), ::testing::Not(HasSubstr("changed on disk")));
    write("box.obj", test::boxSoup(Vec3(2.5, 3, 3), 5));
    look(1);
    EXPECT_THAT(hint(), ::testing::Not(HasSubstr("changed on disk"))) << "may still be written";
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
    EXPECT_THAT(hint(), ::testing::Not(HasSubstr("changed on disk")));
    for (int i = 0; i < 8 && volume() != before; ++i) {  // gravity may be among the changes
        tap(Key::z, {.control = true});
        settle();
    }
    EXPECT_EQ(volume(), before);
    EXPECT_EQ(pieces(), 2) << "the scene before, with its cut";
}

TEST_F(EditorModelsTest, AnIgnoredChangeIsOfferedNoMore) {
    write("box.obj", test::boxSoup(Vec3(2.5, 3, 3), 5));
    look(2);
    click("hint.Esc");
    look(3);
    EXPECT_THAT(hint(), ::testing::Not(HasSubstr("changed on disk")));
    write("box.obj", test::boxSoup(Vec3(2.5, 3.2, 3), 5));
    look(2);
    EXPECT_EQ(hint(), "box.obj has changed on disk. Reload it?");
    tap(Key::escape);
    EXPECT_THAT(hint(), ::testing::Not(HasSubstr("changed on disk")));
}

// Without a word the session was saved for another model, also after Ignore and after an undo.
TEST_F(EditorModelsTest, SavingTellsThatTheModelHasChanged) {
    cut();
    saveByKeys();
    EXPECT_THAT(panels().toast.text, ::testing::Not(HasSubstr("has changed")));
    write("box.obj", test::boxSoup(Vec3(2.5, 3, 3), 5));
    look(2);
    click("hint.Esc");
    saveByKeys();
    EXPECT_THAT(panels().toast.text, HasSubstr("box.obj has changed since it was read; the "
                                               "saved session will use the new version."));
    tap(Key::f5);
    finish();
    saveByKeys();
    EXPECT_THAT(panels().toast.text, ::testing::Not(HasSubstr("has changed")));
    for (int i = 0; i < 8 && panels().toast.text != "Undone: Reload"; ++i) {
        tap(Key::z, {.control = true});
        finish();
    }
    saveByKeys();
    EXPECT_THAT(panels().toast.text, HasSubstr("has changed since it was read"));
    std::filesystem::remove(folder / "box.obj");
    saveByKeys();
    EXPECT_THAT(panels().toast.text, HasSubstr("box.obj is gone; the saved session needs it."));
}

TEST_F(EditorModelsTest, CutsThatMissTheNewModelAreTold) {
    cut();
    TriangleSoup low = test::boxSoup(Vec3(3, 3, 3), 4);
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
    test::writeText(folder / "box.obj", "no model at all");
    tap(Key::f5);
    finish();
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_THAT(panels().toast.text, HasSubstr("box.obj"));
    std::filesystem::remove(folder / "box.obj");
    look(3);
    EXPECT_THAT(hint(), ::testing::Not(HasSubstr("changed on disk")));
    EXPECT_EQ(pieces(), 2);
}

TEST_F(EditorModelsTest, AnUntouchedModelIsReloadedAndStaysSaved) {
    write("box.obj", test::boxSoup(Vec3(2.5, 3, 3), 5));
    tap(Key::f5);
    finish();
    editor->askToLeave();
    EXPECT_TRUE(editor->closing()) << panels().question.text;
}

TEST_F(EditorModelsTest, AddingAModelKeepsTheCuts) {
    write("stool.obj", test::boxSoup(Vec3(4, 2, 2), 2));
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
    write("stool.obj", test::boxSoup(Vec3(3, 3, 3), 4));
    cut(Vec3::UnitX());
    add("stool.obj");
    EXPECT_EQ(pieces(), 4);
    EXPECT_THAT(panels().toast.text, HasSubstr("The same cuts make 4 pieces now, instead of 3."));
}

TEST_F(EditorModelsTest, RemovingIsAskedWhereWhatWasDoneIsAboutTheModel) {
    write("stool.obj", test::boxSoup(Vec3(4, 2, 2), 2));
    add("stool.obj");
    ASSERT_EQ(editor->scene()->execute(SetParam{"density@1", 500.0}), "");
    editor->resize(1280, 1200);
    frames(2);
    click("model.remove.1");
    frames(2);
    EXPECT_EQ(panels().question.title, "Removing stool resets the scene");
    EXPECT_THAT(panels().question.choices,
                ::testing::ElementsAre("Save...", "Reset and remove", "Cancel"));
    click("question.1");
    finish();
    EXPECT_EQ(panels().model.models.size(), 1U);
}

}  // namespace
}  // namespace kerf::app
