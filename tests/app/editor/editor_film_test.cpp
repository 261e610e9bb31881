// A film of what was done in the window.
#include <gmock/gmock.h>

#include "app/scene/editor_scene.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/support/program_output.h"
#include "tests/support/run_kerf.h"
#include "tests/support/variable.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class EditorFilmTest : public EditorTest {
  protected:
    void openSession(int steps) {
        test::writeText(folder / "slice.kerf.json", R"({
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
        tap(Key::m, {.control = true});
        frames(2);
        ASSERT_EQ(panels().files.purpose, ui::FilePurpose::makeFilm);
        ASSERT_EQ(panels().files.name.substr(0, 9), "slice-cut");
        type(name);
    }
};

TEST_F(EditorFilmTest, TheDialogMakesAFilmOfAllSinceTheStart) {
    openSession(8);
    askForFilm("cut.webm");
    click("file.speed");
    frames(2);
    click("file.speed.1/10 speed");
    frames(2);
    click("file.turntable");
    frames(2);
    for (const char* const choice : {"size", "size.640 x 360", "rate", "rate.50 fps"}) {
        click(std::string("file.") + choice);
        frames(2);
    }
    EXPECT_TRUE(panels().files.film.turntable);
    EXPECT_EQ(panels().files.film.speed, 0.1);
    click("file.accept");
    waitForWork();
    EXPECT_THAT(panels().toast.text, HasSubstr("Exported video " + (folder / "cut.webm").string()));
    EXPECT_EQ(test::outputOf("ffprobe -v error -count_frames -show_entries "
                             "stream=codec_name,width,height,nb_read_frames -of csv=p=0 '" +
                             (folder / "cut.webm").string() + "'"),
              "vp9,640,360,21\n")
        << "0.04 s, ten times slower, 50 pictures a second";
}

TEST_F(EditorFilmTest, ACutInAPauseLastsAsLongAsTheDrag) {
    const auto drag = [&](double x) {
        moveTo(x, kTop.y());
        press(true);
        frames(1);
        for (int i = 1; i <= 60; ++i) {
            moveTo(x, kTop.y() + (kBottom - kTop).y() * i / 60);
            frames(1);
        }
        press(false);
        frames(1);
        settle();
    };
    drag(kTop.x());
    tap(Key::m, {.control = true});
    frames(2);
    type("cut.mp4");
    click("file.size");
    click("file.size.640 x 360");
    click("file.accept");
    waitForWork();
    const std::string frames = test::outputOf(
        "ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 '" +
        (folder / "cut.mp4").string() + "'");
    EXPECT_NEAR(std::stoi(frames), 30, 3) << "a second";
}

TEST_F(EditorFilmTest, IsSeenFromWhereThePersonLooksNow) {
    openSession(8);
    const auto film = [&](const std::string& name) {
        askForFilm(name);
        click("file.size");
        click("file.size.640 x 360");
        click("file.accept");
        waitForWork();
        return test::readBytes(folder / name);
    };
    const std::string before = film("before.mp4");
    EXPECT_EQ(film("again.mp4"), before);
    tap(Key::digit7);
    frames(60);
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
    click("work.cancel");
    waitForWork();
    const auto files = [&] { return std::distance(fs::directory_iterator(folder.path()), {}); };
    for (int i = 0; i < 2000 && files() != before; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // until it has heard of it
    }
    EXPECT_EQ(files(), before);
}

TEST_F(EditorFilmTest, WithoutFfmpegASentenceSaysSo) {
    openSession(20);
    fs::create_directory(folder / "empty");
    const test::Variable path("PATH", folder / "empty");
    askForFilm("cut.mp4");
    tap(Key::enter);
    waitForWork();
    EXPECT_THAT(panels().toast.text, HasSubstr("The video could not be exported: "));
    EXPECT_THAT(panels().toast.text, HasSubstr("film.mp4: films are made by the program ffmpeg"));
    EXPECT_TRUE(panels().toast.isError);
    EXPECT_FALSE(fs::exists(folder / "cut.mp4"));
}

}  // namespace
}  // namespace kerf::app
