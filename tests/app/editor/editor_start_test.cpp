// The start page: scenes and recent files to begin with.

#include "app/editor/storage/settings_file.h"
#include "app/editor/view/editor_panels.h"
#include "app/files/io/file_io.h"
#include "app/scene/editor_scene.h"
#include "app/session/material.h"
#include "sim/run/simulation.h"
#include "tests/app/editor/editor_fixture.h"
#include "ui/panels/panels.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class EditorStart : public EditorTest {
  protected:
    EditorOptions options() override {
        EditorOptions options = EditorTest::options();
        options.recentFiles = folder / "recent";
        return options;
    }
    void startEmpty() {
        editor = std::make_unique<Editor>(options(), std::nullopt);
        frames(2);
    }
    bool showsPage() const { return editor->itemRects().contains("start.citrus"); }
    void cutAcross() {
        drag(kTop, kBottom, 20);
        settle();
    }
};

TEST_F(EditorStart, WithoutAFileThePageIsShownAlone) {
    startEmpty();
    EXPECT_EQ(editor->title(), "Kerf");
    EXPECT_TRUE(showsPage());
    EXPECT_FALSE(editor->itemRects().contains("transport.play"));
    tap(Key::escape);
    tap(Key::space);
    EXPECT_TRUE(showsPage()) << "nothing else is there";
}

TEST_F(EditorStart, ACardOpensItsSceneAndTellsWhatToTry) {
    startEmpty();
    click("start.jelly");
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - jelly - 1 piece");
    EXPECT_FALSE(showsPage());
    EXPECT_EQ(panels().help.hint.text, "Press Shift+Space: it falls and wobbles. Then cut it.");
    EXPECT_TRUE(panels().files.recent.empty()) << "it is no file of a person's";
    cutAcross();
    EXPECT_EQ(editor->title(), "Kerf - jelly - 2 pieces");
    EXPECT_THAT(panels().help.hint.text, StartsWith("Cut into 2 pieces"));
}

TEST_F(EditorStart, ArrowsAndEnterChooseACard) {
    startEmpty();
    tap(Key::right);
    tap(Key::down);
    frames(1);
    tap(Key::enter);
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - egg - 1 piece") << "below the second card";
}

TEST_F(EditorStart, NewShowsItOverTheScene) {
    tap(Key::n, {.control = true});
    frames(2);
    EXPECT_TRUE(showsPage());
    const std::string before = editor->title();
    tap(Key::v);
    EXPECT_EQ(panels().parameters.now.gravity, Vec3::Zero()) << "keys of the scene wait";
    tap(Key::escape);
    frames(2);
    EXPECT_FALSE(showsPage());
    tap(Key::n, {.control = true});
    frames(2);
    moveTo(3, 3);
    press(true);
    press(false);
    frames(3);
    EXPECT_FALSE(showsPage()) << "a click beside it";
    EXPECT_EQ(editor->title(), before);
}

TEST_F(EditorStart, OpeningAsksAboutUnsavedWork) {
    cutAcross();
    tap(Key::n, {.control = true});
    frames(2);
    click("start.egg");
    EXPECT_THAT(panels().question.title, HasSubstr("Hollow egg"));
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorStart, RecentFilesThatAreGoneAreLeftOut) {
    const std::filesystem::path here = folder / "here.kerf.json";
    writeOutputFile(here, R"({"format": "kerf-session", "version": 1,
                              "model": {"builtin": "sphere80"}, "steps": 1, "events": []})");
    RecentFiles store(folder / "recent");
    writeOutputFile(folder / "gone.obj", "");
    store.add(folder / "gone.obj");
    store.add(here);
    std::filesystem::remove(folder / "gone.obj");
    startEmpty();
    EXPECT_FALSE(editor->itemRects().contains("start.recent.gone.obj"));
    click("start.recent.here.kerf.json");
    waitForWork();
    EXPECT_EQ(editor->title(), "Kerf - here - 1 piece");
}

TEST_F(EditorStart, ItFitsEveryWindow) {
    for (const auto& [width, height, scale] :
         {std::tuple{640, 360, 1.0F}, {800, 600, 1.0F}, {1280, 720, 1.0F}, {3840, 2160, 2.0F}}) {
        startEmpty();
        editor->resize(width, height);
        editor->setScale(scale);
        frames(3);
        const auto inWindow = [w = float(width), least = 60 * scale](const ui::Rect& r) {
            return r.x >= 0 && r.x + r.width <= w && r.width > least;
        };
        for (const ui::StartCard& scene : *startCards()) {
            EXPECT_TRUE(inWindow(editor->itemRects().at("start." + scene.name)))
                << scene.name << " in " << width << " x " << height;
        }
        const ui::Rect page = editor->itemRects().at("start");
        EXPECT_GE(page.y, 0);
        EXPECT_LE(page.y + page.height, height);
    }
}

/// Each scene opens with a material by name and weight, and is cut as its line says.
TEST_F(EditorStart, EverySceneIsCut) {
    for (const ui::StartCard& scene : *startCards()) {
        SCOPED_TRACE(scene.name);
        EXPECT_NE(scene.picture, nullptr);
        if (scene.name.starts_with("../practice/")) {
            EXPECT_TRUE(openDocument(startSession(scene.name)).session.task);
            continue;  // phantoms, for EditorPractice
        }
        Document document = openDocument(startSession(scene.name));
        EXPECT_EQ(document.note, "");
        const Params& params = document.session.params;
        EXPECT_LT(params.gravity.y(), 0);
        EXPECT_TRUE(isMadeOf(params, findMaterial(document.session.material, {})));
        start(options(), std::move(document));
        const int triangles = editor->scene()->simulation().report().triangles;
        EXPECT_GE(triangles, 2000);
        const bool incised = scene.name == "liver";
        if (incised) {
            tap(Key::s);
            const ui::Rect view = ui::layoutPanels(float(kWidth), float(kHeight), 1, {}, true).view;
            const Vec2 middle(view.x + view.width / 2, view.y + view.height / 2);
            drag(middle - Vec2(25, 0), middle + Vec2(25, 0), 20);
            settle();
        } else {
            cutAcross();
        }
        const std::size_t pieces = panels().pieces.rows.size();
        EXPECT_TRUE(incised ? pieces == 1 : pieces >= 2) << pieces;
        EXPECT_GT(editor->scene()->simulation().report().triangles, triangles);
        EXPECT_THAT(ui::remarkOn(*findParam("iterations"), panels().parameters),
                    testing::HasSubstr("implicit step"));
    }
}

// As the line of its card says.
TEST_F(EditorStart, TheJellyTearsWhereItIsPulled) {
    startEmpty();
    click("start.tear");
    waitForWork();
    settle();
    EXPECT_EQ(editor->title(), "Kerf - tear - 1 piece");
    tap(Key::d);
    EXPECT_TRUE(editor->itemRects().contains("pull.tears"));
    const ui::Series& taken = (*panels().plots.history)[ui::Reading::fractureEnergy];
    const double before = taken.last();
    moveTo(530, 210);
    press(true);
    std::string hints;
    for (int i = 0; i < 120 && taken.last() == before; ++i) {
        moveTo(530 + 2.0 * i, 210);
        frames(1);
        hints += panels().help.hint.text;
    }
    EXPECT_GT(taken.last(), before);
    EXPECT_THAT(hints, HasSubstr("% of what its end needs. Pull farther."));
    frames(1);
    EXPECT_EQ(panels().help.hint.text, "Tearing at the end of a slit.");
    press(false);
    frames(2);
    EXPECT_THAT(panels().help.hint.text, Not(HasSubstr("earing")));
}

}  // namespace
}  // namespace kerf::app
