// Models with colours and images of their own in the editor.

namespace kerf::app {
namespace {

/// A ball that an image makes green.
class EditorLooksTest : public EditorTest {
  protected:
    void writeGreenBall() {
        std::vector<std::uint8_t> pixels;
        for (int i = 0; i < 16; ++i) {
            pixels.insert(pixels.end(), {20, 220, 40, 255});
        }
        writePng({4, 4, pixels}, folder / "green.png");
        std::string text = "mtllib ball.mtl\nusemtl paint\nvt 0.5 0.5\n";
        std::istringstream lines(objText(cubeSphereSoup(8, 0.5)));
        for (std::string line; std::getline(lines, line);) {
            text +=
                line[0] == 'f' ? std::regex_replace(line, std::regex("( [0-9]+)"), "$1/1") : line;
            text += "\n";
        }
        writeText(folder / "ball.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd green.png\n");
        writeText(folder / "ball.obj", text);
    }
    /// High enough for all sections.
    void startWithRoom() {
        EditorOptions options = plainOptions();
        options.height = 1600;
        start(options);
    }
    void open(const std::string& name) {
        editor->open(folder / name);
        waitForWork();
        moveTo(5, 5);
        settle();
    }
    /// What the middle of the view shows.
    std::array<int, 3> middle() {
        settle();
        const render::Image picture = editor->readPicture();
        const std::size_t at =
            4 * (std::size_t(picture.height / 2) * picture.width + picture.width / 2);
        return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
    }
    static bool isGreen(const std::array<int, 3>& color) {
        return color[1] > 2 * color[0] && color[1] > 2 * color[2];
    }
};

TEST_F(EditorLooksTest, AnImageIsShownFollowsACutAndItsUndo) {
    writeGreenBall();
    open("ball.obj");
    EXPECT_TRUE(isGreen(middle()));
    const std::vector<std::uint8_t> before = viewPixels(editor->readPicture());
    dragAndSettle(kTop, kBottom, 10);
    moveTo(5, 5);
    EXPECT_EQ(editor->title(), "Kerf - ball - 2 pieces");
    tap(Key::t);  // no dark line along the cut
    EXPECT_TRUE(isGreen(middle()));
    tap(Key::t);
    tap(Key::z, {.control = true});
    moveTo(5, 5);
    settle();
    EXPECT_EQ(editor->title(), "Kerf - ball - 1 piece");
    EXPECT_TRUE(isGreen(middle()));
}

TEST_F(EditorLooksTest, TheLookIsShownInsteadOnDemandAndInTheSession) {
    startWithRoom();
    writeGreenBall();
    open("ball.obj");
    ASSERT_TRUE(panels().looks.hasOwnColors);
    ASSERT_TRUE(isGreen(middle()));
    click("section.display");
    click("color.own");
    EXPECT_FALSE(isGreen(middle()));
    const SavedSession saved =
        editor->scene()->recorder().savedSession(render::Camera{}, panels().display.colors);
    EXPECT_TRUE(saved.session.colors.ofLook);
}

TEST_F(EditorLooksTest, AMissingImageIsToldOf) {
    writeGreenBall();
    fs::remove(folder / "green.png");
    open("ball.obj");
    EXPECT_THAT(panels().toast.text,
                HasSubstr("The image \"green.png\" of the material \"paint\""));
    EXPECT_FALSE(isGreen(middle()));
}

// Materials in the editor: chosen by name, taken back, saved and opened as files.

/// Materials of one's own lie in a folder of the test.
class EditorMaterialTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        if (!editor->itemRects().contains("model.material")) {
            click("section.model");
        }
    }
    EditorOptions options() override {
        EditorOptions options = EditorTest::options();
        options.width = 1280;
        options.height = 1200;
        options.materials = folder / "own";
        return options;
    }
    const Params& params() { return editor->scene()->simulation().params(); }
    /// The label of what the body is made of; empty for own values.
    std::string shown() {
        const int number = panels().model.models[0].material;
        return number < 0 ? "" : panels().model.materials[number].label;
    }
    void choose(const std::string& label) {
        click("model.material");
        click("material." + label, 2);
    }
    /// Saves the values as they are under a name.
    void save(const std::string& name) {
        click("model.material");
        click("material.save");
        tap(Key::a, {.control = true});
        type(name);
        confirm(2);
    }
};

TEST_F(EditorMaterialTest, AChoiceSetsValuesAndLookAndIsOneChange) {
    const Params before = params();
    const render::ChosenColors ownColors = panels().display.colors;
    EXPECT_EQ(shown(), "");
    choose("Liver");
    EXPECT_TRUE(isMadeOf(params(), findMaterial("liver", {})));
    EXPECT_EQ(shown(), "Liver");
    EXPECT_EQ(panels().display.colors, findMaterial("liver", {}).colors);
    ASSERT_EQ(panels().changes.done, 1U);
    EXPECT_EQ(panels().changes.rows[0].name, "Material: Liver");
    tap(Key::z, {.control = true});
    EXPECT_EQ(params(), before);
    EXPECT_EQ(shown(), "");
    EXPECT_EQ(panels().display.colors, ownColors);
    tap(Key::z, {.shift = true, .control = true});
    EXPECT_EQ(shown(), "Liver");
    EXPECT_EQ(panels().display.colors, findMaterial("liver", {}).colors);
}

TEST_F(EditorMaterialTest, TooltipTellsValuesSpreadAndSources) {
    for (const ui::MaterialRow& row : panels().model.materials) {
        EXPECT_FALSE(row.own) << row.label;
        EXPECT_THAT(row.tooltip, HasSubstr("Young's modulus: ")) << row.label;
    }
    choose("Kidney");
    const std::string& tooltip =
        panels().model.materials[panels().model.models[0].material].tooltip;
    EXPECT_THAT(tooltip, HasSubstr("Young's modulus: 5.43 kPa (4.92 to 5.94)\n"));
    EXPECT_THAT(tooltip, HasSubstr("Toughness: 160 J/m^2, an estimate\n"));
    EXPECT_THAT(tooltip, HasSubstr("\nSources:\nAmador, Urban, Chen, Greenleaf (2011)"));
}

TEST_F(EditorMaterialTest, IsSavedAsAFileThatStandsInTheList) {
    choose("Gelatin");
    editor->scene()->execute(SetParam{"youngs_modulus", 23456.0});
    frames(2);
    EXPECT_EQ(shown(), "") << "own values";
    save("stiff gel");
    const Material saved = readMaterial(folder / "own" / "stiff gel.material.json");
    EXPECT_TRUE(isMadeOf(params(), saved));
    EXPECT_EQ(saved.colors, panels().display.colors);
    EXPECT_EQ(shown(), "stiff gel");
    EXPECT_TRUE(panels().model.materials.back().own);
    choose("Rubber");
    choose("stiff gel");
    EXPECT_EQ(params().youngsModulus, 23456);
}

TEST_F(EditorMaterialTest, AFileThatIsDroppedIsTakenAtOnce) {
    writeText(folder / "cork.material.json",
              R"({"format": "kerf-material", "version": 1, "label": "Cork",
                        "density": {"value": 240}})");
    editor->post(ui::FileDrop{{folder / "cork.material.json"}});
    frames(3);
    EXPECT_EQ(params().density, 240);
    EXPECT_EQ(shown(), "Cork");
    EXPECT_EQ(panels().name, "ball");
}

TEST_F(EditorMaterialTest, ABadFileIsASentenceAndChangesNothing) {
    const Params before = params();
    writeText(folder / "lead.material.json",
              R"({"format": "kerf-material", "version": 1, "density": {"value": 1e9}})");
    editor->post(ui::FileDrop{{folder / "lead.material.json"}});
    frames(3);
    EXPECT_EQ(panels().toast.text,
              "lead.material.json: density.value: 1e+09 is out of range (10 to 20000).");
    EXPECT_EQ(params(), before);
}

TEST_F(EditorMaterialTest, ASavedSessionHasTheMaterialInItsEvents) {
    choose("Fat");
    editor->scene()->step();
    const Session session =
        editor->scene()
            ->recorder()
            .savedSession(editor->scene()->rest().homeView(), panels().display.colors)
            .session;
    const Session again = parseSession(formatSession(session), folder.path());
    EXPECT_EQ(again.colors, findMaterial("fat", {}).colors);
    int sets = 0;
    for (const SessionEvent& event : again.events) {
        const auto* set = std::get_if<SetParam>(&event.action);
        sets += set != nullptr && set->material == "Fat" ? 1 : 0;
    }
    EXPECT_EQ(sets, 7) << "four as before, toughness and strength, and that it has no skin";
}

// A film of what was done in the window.

class EditorFilmTest : public EditorTest {
  protected:
    void openSession(int steps) {
        writeText(folder / "slice.kerf.json", R"({
            "format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
            "params": {"gravity": [0, 0, 0], "floor": null, "iterations": 4}, "steps": )" +
                                                  std::to_string(steps) + R"(,
            "events": [{"step": 1, "type": "blade", "a": [-2, 1.5, 0.1], "b": [2, 1.5, 0.1]},
                       {"step": 6, "type": "blade", "a": [-2, -1.5, 0.1], "b": [2, -1.5, 0.1]}]})");
        openAtStart(folder / "slice.kerf.json");
        settle();
    }
    /// Opens the dialog and names the film.
    void askForFilm(const std::string& name) {
        tap(Key::m, {.control = true}, 2);
        ASSERT_EQ(panels().files.purpose, ui::FilePurpose::makeFilm);
        ASSERT_EQ(panels().files.name.substr(0, 9), "slice-cut");
        type(name);
    }
};

TEST_F(EditorFilmTest, TheDialogMakesAFilmOfAllSinceTheStart) {
    openSession(8);
    askForFilm("cut.webm");
    click("file.speed", 2);
    click("file.speed.1/10 speed", 2);
    click("file.turntable", 2);
    for (const char* const choice : {"size", "size.640 x 360", "rate", "rate.50 fps"}) {
        click(std::string("file.") + choice, 2);
    }
    EXPECT_TRUE(panels().files.film.turntable);
    EXPECT_EQ(panels().files.film.speed, 0.1);
    clickAndWait("file.accept");
    EXPECT_THAT(panels().toast.text, HasSubstr("Exported video " + (folder / "cut.webm").string()));
    EXPECT_EQ(outputOf("ffprobe -v error -count_frames -show_entries "
                       "stream=codec_name,width,height,nb_read_frames -of csv=p=0 '" +
                       (folder / "cut.webm").string() + "'"),
              "vp9,640,360,21\n")
        << "0.04 s, ten times slower, 50 pictures a second";
}

TEST_F(EditorFilmTest, ACutInAPauseLastsAsLongAsTheDrag) {
    const auto drag = [&](double x) {
        moveTo(x, kTop.y());
        press(true, 1);
        for (int i = 1; i <= 60; ++i) {
            moveTo(x, kTop.y() + (kBottom - kTop).y() * i / 60, 1);
        }
        press(false, 1);
        settle();
    };
    drag(kTop.x());
    tap(Key::m, {.control = true}, 2);
    type("cut.mp4");
    click("file.size");
    click("file.size.640 x 360");
    clickAndWait("file.accept");
    const std::string frames = outputOf(
        "ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 '" +
        (folder / "cut.mp4").string() + "'");
    EXPECT_NEAR(std::stoi(frames), 30, 3) << "a second";
}

TEST_F(EditorFilmTest, AnAnimationHasTheMeshesInstead) {
    openSession(20);
    askForFilm("cut.abc");
    clickAndWait("file.accept");
    EXPECT_THAT(panels().toast.text,
                HasSubstr("Exported animation " + (folder / "cut.abc").string()));
    EXPECT_EQ(readBytes(folder / "cut.abc").substr(0, 6), "Ogawa\xFF");
    fs::create_directory(folder / "a & b");
    for (const char* name : {"step-000998.vtp", "step-one.vtp", "step-000998.ply"}) {
        writeText(folder / "a & b" / name, "of an earlier run, or of others");
    }
    askForFilm("a & b.pvd");
    clickAndWait("file.accept");
    EXPECT_THAT(readBytes(folder / "a & b.pvd"),
                AllOf(HasSubstr("file=\"a &amp; b/step-000000.vtp\""),
                      HasSubstr("file=\"a &amp; b/step-000014.vtp\"")))
        << "30 in a second";
    EXPECT_TRUE(fs::exists(folder / "a & b" / "step-000014.vtp"));
    EXPECT_FALSE(fs::exists(folder / "a & b" / "step-000998.vtp"));
    EXPECT_TRUE(fs::exists(folder / "a & b" / "step-one.vtp"));
    EXPECT_TRUE(fs::exists(folder / "a & b" / "step-000998.ply"));
}

TEST_F(EditorFilmTest, IsSeenFromWhereThePersonLooksNow) {
    openSession(8);
    const auto film = [&](const std::string& name) {
        askForFilm(name);
        click("file.size");
        click("file.size.640 x 360");
        clickAndWait("file.accept");
        return readBytes(folder / name);
    };
    const std::string before = film("before.mp4");
    EXPECT_EQ(film("again.mp4"), before);
    tap(Key::digit7, 60);
    EXPECT_NE(film("top.mp4"), before);
}

TEST_F(EditorFilmTest, AFilmThatIsGivenUpLeavesNothing) {
    openSession(20000);
    const auto before = std::distance(fs::directory_iterator(folder.path()), {});
    askForFilm("long.mp4");
    tap(Key::enter);
    for (int i = 0; i < 2000 && panels().work.stage.find("Step ") == std::string::npos; ++i) {
        frames(1);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(panels().work.title, "Exporting video long.mp4");
    EXPECT_TRUE(panels().work.mayEnd);
    clickAndWait("work.cancel");
    const auto files = [&] { return std::distance(fs::directory_iterator(folder.path()), {}); };
    for (int i = 0; i < 2000 && files() != before; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // until it has heard of it
    }
    EXPECT_EQ(files(), before);
}

TEST_F(EditorFilmTest, QuittingMeanwhileSaysThatItIsFinishedFirst) {
    openSession(20000);
    askForFilm("long.mp4");
    tap(Key::enter);
    tap(Key::q, {.control = true});
    waitWhile([&] { return panels().work.title.empty(); });
    EXPECT_EQ(panels().work.title, "Exporting video long.mp4 first, then Kerf closes");
    EXPECT_FALSE(editor->closing());
    click("work.cancel");
    waitWhile([&] { return !editor->closing(); });
    EXPECT_TRUE(editor->closing());
}

TEST_F(EditorFilmTest, WithoutFfmpegASentenceSaysSo) {
    openSession(20);
    fs::create_directory(folder / "empty");
    const Variable path("PATH", folder / "empty");
    askForFilm("cut.mp4");
    confirm();
    EXPECT_THAT(panels().toast.text, HasSubstr("The video could not be exported: "));
    EXPECT_THAT(panels().toast.text, HasSubstr("film.mp4: films are made by the program ffmpeg"));
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_FALSE(fs::exists(folder / "cut.mp4"));
}

}  // namespace
}  // namespace kerf::app
