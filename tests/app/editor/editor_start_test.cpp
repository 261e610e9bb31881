// The start page: scenes and recent files to begin with.
#include "app/editor/storage/driver_check.h"
#include "app/editor/view/editor_panels.h"
#include "app/editor/view/rest_depths.h"
#include "gpu/buffer.h"
#include "gpu/kernel_way.h"
#include "ui/panels/panels.h"

namespace kerf::app {
namespace {

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
    void cutAcross() { dragAndSettle(kTop, kBottom, 20); }
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
    clickAndWait("start.jelly");
    EXPECT_EQ(editor->title(), "Kerf - jelly - 1 piece");
    EXPECT_FALSE(showsPage());
    EXPECT_EQ(panels().help.hint.text, "Press Shift+Space: it falls and wobbles. Then cut it.");
    EXPECT_TRUE(panels().files.recent.empty()) << "it is no file of a person's";
    cutAcross();
    EXPECT_EQ(editor->title(), "Kerf - jelly - 2 pieces");
    EXPECT_THAT(panels().help.hint.text, StartsWith("Cut into 2 pieces"));
}

TEST_F(EditorStart, ACardChoosesItsTool) {
    startEmpty();
    clickAndWait("start.liver");
    EXPECT_EQ(panels().tools.tool, ui::ToolKind::scalpel);
    for (const auto& [card, tool] : {std::pair{"jelly", ui::ToolKind::stroke},
                                     {"tear", ui::ToolKind::grab},
                                     {"incision", ui::ToolKind::retract}}) {
        tap(Key::n, {.control = true}, 2);
        clickAndWait(std::string("start.") + card);
        EXPECT_EQ(panels().tools.tool, tool) << card;
    }
}

TEST_F(EditorStart, TheFirstPictureAfterAClickTellsWhatOpens) {
    startEmpty();
    const ui::Rect card = editor->itemRects().at("start.egg");
    EXPECT_FALSE(editor->itemRects().contains("start.opening"));
    moveTo(card.x + card.width / 2, card.y + card.height / 2);
    press(true);
    press(false, 1);
    ASSERT_TRUE(editor->itemRects().contains("start.opening"));
    const ui::Rect sign = editor->itemRects().at("start.opening");
    EXPECT_TRUE(card.holds(sign.x, sign.y));
    EXPECT_TRUE(editor->working());
    waitForWork();
    EXPECT_FALSE(showsPage());
}

TEST_F(EditorStart, ArrowsAndEnterChooseACard) {
    startEmpty();
    tap(Key::right);
    tap(Key::down, 1);
    confirm();
    EXPECT_EQ(editor->title(), "Kerf - egg - 1 piece") << "below the second card";
}

TEST_F(EditorStart, NewShowsItOverTheScene) {
    tap(Key::n, {.control = true}, 2);
    EXPECT_TRUE(showsPage());
    const std::string before = editor->title();
    tap(Key::v);
    EXPECT_EQ(panels().parameters.now.gravity, Vec3::Zero()) << "keys of the scene wait";
    tap(Key::escape, 2);
    EXPECT_FALSE(showsPage());
    tap(Key::n, {.control = true}, 2);
    moveTo(3, 3);
    press(true);
    press(false, 3);
    EXPECT_FALSE(showsPage()) << "a click beside it";
    EXPECT_EQ(editor->title(), before);
}

TEST_F(EditorStart, OpeningAsksAboutUnsavedWork) {
    cutAcross();
    tap(Key::n, {.control = true}, 2);
    click("start.egg");
    EXPECT_THAT(panels().question.title, HasSubstr("Hollow egg"));
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
}

TEST_F(EditorStart, RecentFilesThatAreGoneAreLeftOut) {
    const fs::path here = folder / "here.kerf.json";
    writeOutputFile(here, R"({"format": "kerf-session", "version": 1,
                              "model": {"builtin": "sphere80"}, "steps": 1, "events": []})");
    RecentFiles store(folder / "recent");
    writeOutputFile(folder / "gone.obj", "");
    store.add(folder / "gone.obj");
    store.add(here);
    fs::remove(folder / "gone.obj");
    startEmpty();
    EXPECT_FALSE(editor->itemRects().contains("start.recent.gone.obj"));
    clickAndWait("start.recent.here.kerf.json");
    EXPECT_EQ(editor->title(), "Kerf - here - 1 piece");
}

TEST_F(EditorStart, ItFitsEveryWindow) {
    for (const auto& [width, height, scale] : {std::tuple{400, 300, 1.0F},
                                               {640, 360, 1.0F},
                                               {800, 600, 1.0F},
                                               {1280, 720, 1.0F},
                                               {1440, 810, 4.0F},
                                               {3840, 2160, 2.0F},
                                               {3840, 2160, 4.0F}}) {
        startEmpty();
        editor->resize(width, height);
        editor->setScale(scale);
        frames(3);
        const float shown = std::min(scale, ui::largestScale(width, height));
        const auto inWindow = [w = float(width), least = 60 * shown](const ui::Rect& r) {
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
            dragAndSettle(middle - Vec2(25, 0), middle + Vec2(25, 0), 20);
        } else {
            cutAcross();
        }
        const std::size_t pieces = panels().pieces.rows.size();
        EXPECT_TRUE(incised ? pieces == 1 : pieces >= 2) << pieces;
        EXPECT_GT(editor->scene()->simulation().report().triangles, triangles);
        EXPECT_THAT(ui::remarkOn(*findParam("iterations"), panels().parameters),
                    HasSubstr("implicit step"));
    }
}

// As the line of its card says.
TEST_F(EditorStart, TheJellyTearsWhereItIsPulled) {
    startEmpty();
    clickAndWait("start.tear");
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
        moveTo(530 + 2.0 * i, 210, 1);
        hints += panels().help.hint.text;
    }
    EXPECT_GT(taken.last(), before);
    EXPECT_THAT(hints, HasSubstr("% of what its end needs. Pull farther."));
    frames(1);
    EXPECT_EQ(panels().help.hint.text, "Tearing at the end of a slit.");
    press(false, 2);
    EXPECT_THAT(panels().help.hint.text, Not(HasSubstr("earing")));
}

// A driver that Kerf meets for the first time is examined behind the window.

class DriverCheckTest : public EditorTest {
  protected:
    /// Instead of kerf: notes that it ran, at low priority, and leaves a report with that end.
    void examinationEnds(const std::string& command, const std::string& verdict) {
        const fs::path program = folder / "examiner.sh";
        const std::string report =
            verdict.empty() ? ""
                            : "echo '{\"verdict\": \"" + verdict + "\"}' > \"$4/doctor.json\"\n";
        writeText(program, "#!/bin/sh\n[ $(nice) -ge 5 ] && echo \"$@\" >> " +
                               (folder / "ran").string() + "\n" + report + command + "\n");
        fs::permissions(program, fs::perms::owner_all);
    }
    EditorOptions examining(const std::string& driver) {
        EditorOptions options = EditorTest::options();
        options.settingsFile = folder / "settings.json";
        options.driverReports = folder / "drivers";
        options.driver = driver;
        return options;
    }
    /// Starts an editor on a driver and waits until it has been examined.
    void meet(const std::string& driver) {
        const Variable program("KERF_EXECUTABLE", (folder / "examiner.sh").string());
        start(examining(driver));
        waitWhile([&] { return editor->idleSeconds() < 1; });
        frames(2);
    }
    std::size_t examinations() const {
        const std::string ran = readBytes(folder / "ran");
        return static_cast<std::size_t>(std::ranges::count(ran, '\n'));
    }
};

TEST_F(DriverCheckTest, ADriverThatIsRightIsExaminedOnceAndNothingIsSaid) {
    examinationEnds("exit 0", "All is well.");
    meet("Maker's renderer (4.6) 1.2");
    meet("Maker's renderer (4.6) 1.2");
    EXPECT_EQ(examinations(), 1u);
    EXPECT_THAT(readBytes(folder / "ran"), HasSubstr("doctor --quick --out "));
    EXPECT_THAT(panels().question.text, IsEmpty());
    meet("Maker's renderer (4.6) 1.3");
    EXPECT_EQ(examinations(), 2u) << "a newer driver is another one";
}

TEST_F(DriverCheckTest, OfAWrongDriverThePersonIsToldAndOfferedTheSoftwareRenderer) {
    examinationEnds("exit 1", "Free fall is wrong.");
    meet("Maker's renderer");
    EXPECT_THAT(panels().question.text, HasSubstr("Free fall is wrong. The report is in"));
    ASSERT_EQ(panels().question.choices.size(), 2u);
    tap(Key::enter, 2);
    EXPECT_THAT(panels().toast.text, HasSubstr("Restart Kerf"));
    EXPECT_THAT(readBytes(folder / "settings.json"), HasSubstr("\"software_renderer\": true"));
    meet("Maker's renderer");
    EXPECT_EQ(examinations(), 1u);
    EXPECT_THAT(panels().question.text, IsEmpty()) << "it is asked once";
}

TEST_F(DriverCheckTest, WhoGoesOnWithTheDriverKeepsIt) {
    examinationEnds("exit 1", "Free fall is wrong.");
    meet("Maker's renderer");
    tap(Key::escape, 2);
    EXPECT_THAT(panels().question.text, IsEmpty());
    EXPECT_FALSE(panels().settings.softwareRenderer);
}

TEST_F(DriverCheckTest, AnExaminationThatCrashesIsTold) {
    examinationEnds("kill -SEGV $$", "");
    meet("Maker's renderer");
    EXPECT_THAT(panels().question.text, HasSubstr("did not finish (it was ended by signal 11)"));
    tap(Key::escape);
    meet("Maker's renderer");
    EXPECT_EQ(examinations(), 2u) << "it may have been the machine";
}

TEST(DriverReports, TheVariableLeavesDriversAlone) {
    const Variable state("XDG_STATE_HOME", "/state");
    EXPECT_EQ(defaultDriverReports(), "/state/kerf/drivers");
    const Variable off("KERF_EXAMINES_DRIVER", "no");
    EXPECT_EQ(defaultDriverReports(), "");
}

std::shared_ptr<const UncutBody> ballOf(double radius) {
    return makeUncutBody(meshOf(icosphereSoup(2, radius)), {{}});
}

TEST(RestDepths, AreThoseThatWereNotedOrElseMeasured) {
    app::RestDepths depths;
    const auto noted = ballOf(0.5);
    const auto unknown = ballOf(0.25);
    render::DepthField field;
    field.deepest = 42;
    depths.note(noted, field);
    EXPECT_EQ(depths.of(noted).deepest, 42);
    EXPECT_EQ(depths.of(unknown).values, render::measureSkinDepth(unknown->mesh).values);
    EXPECT_NEAR(depths.of(unknown).deepest, 0.25, 0.02);
    EXPECT_EQ(depths.of(noted).deepest, 42) << "others are kept";
}

TEST(RestDepths, OfABodyThatIsGoneSayNothingOfTheNext) {
    app::RestDepths depths;
    for (const double radius : {0.5, 0.25, 0.125}) {
        EXPECT_NEAR(depths.of(ballOf(radius)).deepest, radius, 0.1 * radius);
    }
}

}  // namespace
}  // namespace kerf::app
