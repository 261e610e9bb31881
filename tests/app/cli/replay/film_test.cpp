// Films and strips of a run, read by ffprobe and ffmpeg themselves.
#include "app/cli/replay/film.h"

#include "tests/app/cli/replay/small_session_fixture.h"

namespace kerf::app {
namespace {

using testing::AllOf;

// --- When a frame is taken ---------------------------------------------------------------------

/// The states that the frames show, as numbers of steps, where all last equally long.
std::vector<double> framesOf(FilmClock clock, int steps, double timeStep) {
    std::vector<double> shown;
    for (int step = 0; step <= steps; ++step) {
        while (const auto before = clock.takeFrame()) {
            shown.push_back(step - *before);
        }
        clock.pass(timeStep);
    }
    return shown;
}

TEST(FilmClock, TakesFramesAtEqualTimes) {
    const std::vector<double> frames = framesOf(FilmClock(1.0 / 30), 200, 0.005);
    ASSERT_EQ(frames.size(), 31u) << "one second, and its end";
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_NEAR(frames[i], static_cast<double>(i) / 30 / 0.005, 1e-6);
    }
}

TEST(FilmClock, ShowsAStateAsOftenAsSlowMotionNeeds) {
    const std::vector<double> frames = framesOf(FilmClock(0.001), 2, 0.004);
    EXPECT_THAT(frames, testing::Pointwise(testing::DoubleNear(1e-9),
                                           {0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0}));
}

TEST(FilmClock, FollowsATimeStepThatChanges) {
    FilmClock clock(0.01);
    EXPECT_TRUE(clock.takeFrame());
    clock.pass(0.002);
    EXPECT_FALSE(clock.takeFrame());
    clock.pass(0.02);
    EXPECT_TRUE(clock.takeFrame());
    EXPECT_TRUE(clock.takeFrame());
    EXPECT_FALSE(clock.takeFrame());
}

// --- What is said ------------------------------------------------------------------------------

TEST(FilmCaptions, TellWhatHappensAndForHowLong) {
    FilmCaptions captions(0.25);
    EXPECT_EQ(captions.at(0, 0), "0.00 s, 4 times slower");
    captions.note(MoveBlade{}, 1);
    captions.note(MoveBlade{}, 2);
    EXPECT_EQ(captions.at(9, 2.25), "2.25 s, 4 times slower. Cut 1");
    captions.note(LiftBlade{}, 9);
    EXPECT_THAT(captions.at(10, 2.5), HasSubstr("Cut 1"));
    EXPECT_EQ(captions.at(12, 3), "3.00 s, 4 times slower");
    captions.note(SetParam{"gravity", Vec3(0, -9.81, 0)}, 13);
    EXPECT_THAT(captions.at(13, 3.25), AllOf(HasSubstr("Gravity: "), HasSubstr("m/s²")));
    captions.note(MoveBlade{}, 14);
    EXPECT_THAT(captions.at(14, 3.5), HasSubstr("Cut 2"));
}

TEST(FilmCaptions, SayNothingOfThePaceInRealTime) {
    EXPECT_EQ(FilmCaptions(1).at(0, 1.5), "1.50 s");
    EXPECT_EQ(FilmCaptions(2).at(0, 1.5), "1.50 s, 2 times faster");
}

// --- Whole runs --------------------------------------------------------------------------------

class FilmTest : public SmallSessionTest {
  protected:
    /// "h264,320,180,30/1,61": what ffprobe says of a film.
    std::string probed(const std::string& film) {
        return outputOf(
            "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
            "stream=codec_name,width,height,avg_frame_rate,nb_read_frames -of csv=p=0 '" +
            path(film) + "'");
    }
    /// A frame of a film, as ffmpeg reads it.
    render::Image frame(const std::string& film, int number) {
        const std::string file = path("frame-" + std::to_string(number) + ".png");
        const std::string said =
            outputOf("ffmpeg -v error -y -i '" + path(film) + "' -vf 'select=eq(n\\," +
                     std::to_string(number) + ")' -frames:v 1 -update 1 '" + file + "' 2>&1");
        EXPECT_EQ(said, "");
        return render::readPng(file);
    }
    /// Mean difference of the bytes of a rectangle of two pictures.
    static double difference(const render::Image& a, const render::Image& b,
                             const render::PixelRect& part) {
        double sum = 0;
        for (int y = part.y; y < part.y + part.height; ++y) {
            for (int i = 4 * part.x; i < 4 * (part.x + part.width); ++i) {
                const std::size_t at = std::size_t(4) * a.width * y + i;
                sum += std::abs(int(a.pixels.at(at)) - int(b.pixels.at(at)));
            }
        }
        return sum / (4.0 * part.width * part.height);
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder_.path())) {
            all.push_back(entry.path().filename());
        }
        return all;
    }
};

TEST_F(FilmTest, EachFormatHasTheFramesTheSizeAndTheRate) {
    const ProgramRun mp4 =
        replay({"--movie", path("a.mp4"), "--size", "320x180", "--speed", "0.1", "--json"});
    ASSERT_EQ(mp4.exitCode, 0) << mp4.errors;
    EXPECT_EQ(probed("a.mp4"), "h264,320,180,30/1,61\n");
    const auto told = Json::parse(mp4.out)["movie"];
    EXPECT_EQ(told["frames"], 61);
    EXPECT_EQ(told["file"], path("a.mp4"));
    EXPECT_NEAR(told["seconds"], 61.0 / 30, 1e-9);
    const CsvTable metrics(path("out/metrics.csv"), 1 << 20);
    EXPECT_GT(metrics.number(5, metrics.require("render_ms")), 0) << "frames are pictures too";

    const ProgramRun webm = replay({"--movie", path("b.webm"), "--size", "160x90", "--fps", "10"});
    ASSERT_EQ(webm.exitCode, 0) << webm.errors;
    EXPECT_EQ(probed("b.webm"), "vp9,160,90,10/1,3\n") << "0, 0.1 and 0.2 s";
    EXPECT_THAT(webm.out, HasSubstr("film: " + path("b.webm") + ", 3 pictures, 0.3 s\n"));

    const ProgramRun gif = replay({"--movie", path("c.GIF"), "--size", "75x51"});
    ASSERT_EQ(gif.exitCode, 0) << gif.errors;
    EXPECT_EQ(probed("c.GIF"), "gif,75,51,25/1,6\n");
    for (const auto& entry : fs::directory_iterator(path("out"))) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".film")) << entry.path();
    }
    EXPECT_THAT(names(), UnorderedElementsAre("test.kerf.json", "out", "a.mp4", "b.webm", "c.GIF"))
        << "and nothing that is not finished";
}

TEST_F(FilmTest, WhatAHandDidWhileTimeStoodLastsAsLongAsItTook) {
    writeText(path("test.kerf.json"),
              R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
                  "params": {"gravity": [0, 0, 0], "floor": null}, "steps": 30, "events": [
                  {"step": 0, "type": "hold"},
                  {"step": 0, "type": "blade", "a": [-1, 1, 0.1], "b": [1, 1, 0.1]},
                  {"step": 20, "type": "blade", "a": [-1, -1, 0.1], "b": [1, -1, 0.1],
                   "seconds": 0.1},
                  {"step": 20, "type": "run"},
                  {"step": 21, "type": "lift"}]})");
    ASSERT_EQ(replay({"--movie", path("a.mp4"), "--size", "96x64", "--fps", "10"}).exitCode, 0);
    EXPECT_EQ(probed("a.mp4"), "h264,96,64,10/1,20\n") << "1.9 s by hand, 0.055 s of the body";
}

TEST_F(FilmTest, AFilmChangesNeitherStatesNorScreenshots) {
    ASSERT_EQ(replay({"--hashes"}).exitCode, 0);
    const std::string hashes = readBytes(path("out/hashes.csv"));
    const std::string picture = readBytes(path("out/pictures/half.png"));
    const ProgramRun run = replay({"--hashes", "--movie", path("a.mp4"), "--size", "160x90",
                                   "--captions", "--turntable", "--strip", path("a.png"), "3"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(readBytes(path("out/hashes.csv")), hashes);
    EXPECT_EQ(readBytes(path("out/pictures/half.png")), picture);
    EXPECT_FALSE(fs::exists(path("out/.film.part")));
}

TEST_F(FilmTest, TheFilmShowsTheRun) {
    ASSERT_EQ(replay({"--movie", path("a.mp4"), "--size", "96x64", "--speed", "0.1"}).exitCode, 0);
    const render::Image end = render::readPng(path("out/end.png"));
    const render::PixelRect all{0, 0, 96, 64};
    EXPECT_LT(difference(frame("a.mp4", 60), end, all), 2) << "encoded, but the same";
    EXPECT_GT(difference(frame("a.mp4", 0), end, all), 2.5) << "it was whole then";
}

TEST_F(FilmTest, ATurntableComesRoundOnce) {
    writeText(path("test.kerf.json"),
              R"({"format": "kerf-session", "version": 1, "model": {"builtin": "banana"},
                  "params": {"gravity": [0, 0, 0], "floor": null}, "steps": 24})");
    const auto film = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> words{"--movie", path(name), "--size", "160x120", "--fps", "100"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(replay(words).exitCode, 0);
        ASSERT_EQ(probed(name), "h264,160,120,100/1,13\n");
    };
    film("still.mp4", {});
    film("turning.mp4", {"--turntable"});
    const render::PixelRect all{0, 0, 160, 120};
    const render::Image start = frame("still.mp4", 0);
    EXPECT_LT(difference(frame("still.mp4", 6), start, all), 0.5);
    EXPECT_LT(difference(frame("turning.mp4", 0), start, all), 1);
    EXPECT_GT(difference(frame("turning.mp4", 6), start, all), 2.5) << "from behind";
    EXPECT_LT(difference(frame("turning.mp4", 12), start, all), 1);
}

TEST_F(FilmTest, TheCameraGoesFromKeyToKey) {
    const std::string scene = R"("format": "kerf-session", "version": 1,
        "model": {"builtin": "banana"}, "params": {"gravity": [0, 0, 0], "floor": null},
        "steps": 24)";
    const std::string side = R"("eye": [1.8, 0, 0], "target": [0, 0, 0])";
    const std::string front = R"("eye": [0, 0, 1.8], "target": [0, 0, 0])";
    const auto film = [&](const std::string& name, const std::string& more) {
        writeText(path("test.kerf.json"), "{" + scene + ", " + more + "}");
        ASSERT_EQ(replay({"--movie", path(name + ".mp4"), "--size", "160x120", "--fps", "100",
                          "--strip", path(name + ".png"), "2"})
                      .exitCode,
                  0);
        ASSERT_EQ(probed(name + ".mp4"), "h264,160,120,100/1,13\n");
    };
    film("front", R"("view": {)" + front + "}");
    film("side", R"("view": {)" + side + "}");
    film("keys", R"("view": {)" + side + R"(}, "events": [{"step": 4, "type": "camera", )" + front +
                     R"(}, {"step": 20, "type": "camera", )" + side +
                     R"(}, {"step": 24, "type": "screenshot", "file": "end.png", "width": 160,
                            "height": 120}])");
    const render::PixelRect all{0, 0, 160, 120};
    const render::Image fromFront = frame("front.mp4", 0);
    const render::Image fromSide = frame("side.mp4", 0);
    ASSERT_GT(difference(fromFront, fromSide, all), 4);
    EXPECT_LT(difference(frame("keys.mp4", 0), fromFront, all), 1) << "still before the first key";
    EXPECT_LT(difference(frame("keys.mp4", 2), fromFront, all), 1);
    EXPECT_GT(difference(frame("keys.mp4", 6), fromFront, all), 2) << "on the way";
    EXPECT_GT(difference(frame("keys.mp4", 6), fromSide, all), 2);
    EXPECT_LT(difference(frame("keys.mp4", 10), fromSide, all), 1);
    EXPECT_LT(difference(frame("keys.mp4", 12), fromSide, all), 1);
    EXPECT_LT(difference(render::readPng(path("out/end.png")), fromSide, all), 2)
        << "screenshots keep the view";
    EXPECT_NE(readBytes(path("keys.png")), readBytes(path("side.png"))) << "strips have the keys";
}

TEST_F(FilmTest, CaptionsStandInTheLowerLeftCorner) {
    const std::vector<std::string> film{"--size", "640x360", "--speed", "0.1", "--until", "12"};
    const auto make = [&](const std::string& name, const std::string& more) {
        std::vector<std::string> words{"--movie", path(name)};
        words.insert(words.end(), film.begin(), film.end());
        if (!more.empty()) {
            words.push_back(more);
        }
        ASSERT_EQ(replay(words).exitCode, 0);
    };
    make("plain.mp4", "");
    make("told.mp4", "--captions");
    const render::Image plain = frame("plain.mp4", 10);
    const render::Image told = frame("told.mp4", 10);
    EXPECT_GT(difference(plain, told, {10, 325, 200, 22}), 12);
    EXPECT_LT(difference(plain, told, {0, 0, 640, 300}), 0.5);
}

TEST_F(FilmTest, WithoutFfmpegNothingIsBegun) {
    fs::create_directory(path("empty"));
    const ProgramRun run = replay({"--movie", path("a.mp4")}, {{"PATH", path("empty")}});
    EXPECT_EQ(run.exitCode, 5);
    EXPECT_EQ(run.errors, "kerf: " + path("a.mp4") +
                              ": films are made by the program ffmpeg, which is not there; install "
                              "the package ffmpeg.\n");
    EXPECT_THAT(names(), UnorderedElementsAre("test.kerf.json", "empty")) << "no folder out";
}

TEST_F(FilmTest, WhatFfmpegComplainsOfIsToldAndLeavesNoFilm) {
    writeText(path("a.mp4"), "the film of yesterday");
    for (const char* const program :
         {"#!/bin/sh\necho 'Unknown encoder' >&2\nexit 1\n",
          "#!/bin/sh\n/bin/cat > /dev/null\necho 'Unknown encoder' >&2\nexit 1\n"}) {
        fs::create_directories(path("bin"));
        writeText(path("bin/ffmpeg"), program);
        fs::permissions(path("bin/ffmpeg"), fs::perms::owner_all);
        const ProgramRun run = replay({"--movie", path("a.mp4")}, {{"PATH", path("bin")}});
        EXPECT_EQ(run.exitCode, 5);
        EXPECT_EQ(run.errors, "kerf: " + path("a.mp4") +
                                  ": ffmpeg could not make the film (Unknown encoder); choose "
                                  "another format or folder.\n");
        EXPECT_EQ(readBytes(path("a.mp4")), "the film of yesterday");
        EXPECT_FALSE(fs::exists(path("out/summary.json")));
        EXPECT_FALSE(fs::exists(path("out/.film.part")));
    }
}

TEST_F(FilmTest, ARunThatEndsEarlyHasItsFilmUntilThere) {
    writeText(path("test.kerf.json"),
              smallSession(R"(, {"step": 20, "type": "check", "pieces": 7})"));
    const ProgramRun run = replay({"--movie", path("a.mp4"), "--size", "64x48", "--fps", "100"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(probed("a.mp4"), "h264,64,48,100/1,11\n") << "0 to 0.1 s";
}

TEST_F(FilmTest, MistakesAreRefusedBeforeAnythingRuns) {
    const std::string film = path("a.mp4");
    const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
        {{"--movie", path("a.avi")}, ".mp4, .webm or .gif"},
        {{"--movie", film, "--size", "321x180"}, "the sides of a film in the format MP4 are even"},
        {{"--movie", film, "--size", "321"}, "is no size as 1280x720"},
        {{"--movie", film, "--fps", "0"}, "--fps"},
        {{"--movie", film, "--speed", "nan"}, "no number from 0.001 to 1000"},
        {{"--movie", film, "--speed", "0"}, "no number from 0.001 to 1000"},
        {{"--captions"}, "--movie"},
        {{"--turntable"}, "--movie"},
        {{"--size", "64x48"}, "--movie or --strip"},
        {{"--strip", path("a.jpg"), "3"}, ".png"},
        {{"--strip", path("a.png"), "1"}, "at least 2 and at most 32"},
        {{"--strip", path("a.png"), "33"}, "at least 2 and at most 32"},
        {{"--strip", path("a.png"), "3", "--size", "8192x64"}, "--size makes them smaller"},
    };
    for (const auto& [options, words] : mistakes) {
        const ProgramRun run = replay(options);
        EXPECT_EQ(run.exitCode, 2) << options.front() << " " << options.back();
        EXPECT_THAT(run.errors, HasSubstr(words));
    }
    const ProgramRun run = replay({"--movie", path("missing/a.mp4")});
    expectEnd(run, 5, "that folder doesn't exist");
    EXPECT_THAT(names(), UnorderedElementsAre("test.kerf.json"));
}

TEST_F(FilmTest, AStripHasItsPicturesSideBySide) {
    const ProgramRun run = replay({"--strip", path("a.png"), "4", "--size", "96x64"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_THAT(run.out, HasSubstr("strip: " + path("a.png")));
    const render::Image strip = render::readPng(path("a.png"));
    EXPECT_GT(strip.width, 4 * 96);
    EXPECT_LT(strip.width, 4 * 96 + 5 * 16 + 1);
    // The last one is the session's own picture of the end.
    const render::Image end = render::readPng(path("out/end.png"));
    int found = 0;
    for (int top = 0; top + 64 <= strip.height; ++top) {
        for (int left = strip.width - 96 - 32; left + 96 <= strip.width; ++left) {
            bool same = true;
            for (int y = 0; y < 64 && same; ++y) {
                const auto row = strip.pixels.begin() + 4 * ((top + y) * strip.width + left);
                same = std::equal(row, row + 4 * 96, end.pixels.begin() + 4 * 96 * y);
            }
            found += same ? 1 : 0;
        }
    }
    EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace kerf::app
