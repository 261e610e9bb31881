// kerf materials, and kerf replay --material.
#include "app/cli/compare_verb.h"
#include "app/cli/verb.h"
#include "tests/support/png_head.h"

namespace kerf::app {
namespace {

TEST(MaterialsVerb, ListsALineForEach) {
    const ProgramRun run = runKerf({"materials"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    for (const std::string& name : app::materialNames()) {
        EXPECT_THAT("\n" + run.out, HasSubstr("\n" + name + " ")) << name;
    }
    EXPECT_EQ(std::ranges::count(run.out, '\n'), std::ssize(app::materialNames()));
}

TEST(MaterialsVerb, ShowsOneWithItsSpreadAndSources) {
    const ProgramRun run = runKerf({"materials", "liver"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_THAT(run.out, StartsWith("Liver: "));
    EXPECT_THAT(run.out, HasSubstr("\nYoung's modulus: 5.4 kPa (4.2 to 6.6)\n    Physics in"));
    EXPECT_THAT(run.out, HasSubstr("\nFriction: 0.3, an estimate\n    Estimate: "));
    EXPECT_THAT(run.out, HasSubstr("\nToughness: 164 J/m^2 (76 to 225)\n"));
    EXPECT_THAT(run.out, HasSubstr("\nTensile strength: 50 kPa (36 to 55.3)\n    Dunford"));
    EXPECT_THAT(run.out, Not(HasSubstr("Skin")));
    EXPECT_THAT(runKerf({"materials", "banana"}).out,
                HasSubstr("\nSkin tensile strength: 300 kPa, an estimate\n"));
}

TEST(MaterialsVerb, HasJsonAsInFiles) {
    const ProgramRun all = runKerf({"materials", "--json"});
    ASSERT_EQ(all.exitCode, 0) << all.errors;
    const Json list = Json::parse(all.out).at("materials");
    EXPECT_EQ(list.size(), app::materialNames().size());
    const ProgramRun one = runKerf({"materials", "brain", "--json"});
    ASSERT_EQ(one.exitCode, 0) << one.errors;
    Json brain = Json::parse(one.out);
    EXPECT_TRUE(std::ranges::find(list, brain) != list.end());
    EXPECT_EQ(brain.at("name"), "brain");
    EXPECT_EQ(brain.at("format"), "kerf-material");
}

TEST(MaterialsVerb, RefusesWhatIsNoMaterial) {
    const ProgramRun unknown = runKerf({"materials", "adamant"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_THAT(unknown.errors, HasSubstr("there is no material 'adamant'; there are agar, "));
    const test::TemporaryFolder folder;
    writeText(folder / "bad.json", "{}");
    const ProgramRun bad = runKerf({"materials", folder / "bad.json"});
    expectEnd(bad, 3, "bad.json: format: this key is missing");
}

TEST(ReplayMaterial, SetsTheSameAsItsValuesAndAsTheKeyInTheSession) {
    const test::TemporaryFolder folder;
    const std::string head = R"({"format": "kerf-session", "version": 1, "steps": 3,
        "model": {"builtin": "sphere20"}, "params": {"floor": -0.4})";
    writeText(folder / "plain.kerf.json", head + "}");
    writeText(folder / "named.kerf.json", head + R"(, "material": "tofu"})");
    const auto hashOf = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--out", (folder / "out").string(), "--json"});
        const ProgramRun run = runKerf(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.errors;
        return Json::parse(run.out).at("state_hash").get<std::string>();
    };
    const std::string plain = folder / "plain.kerf.json";
    const std::string named = folder / "named.kerf.json";
    const app::Material tofu = app::findMaterial("tofu", {});
    std::vector<std::string> byValues{"replay", plain};
    for (const SetParam& set : app::settingsOf(tofu)) {
        byValues.insert(byValues.end(),
                        {"--set", set.name + "=" + Json(std::get<double>(set.value)).dump()});
    }
    const std::string expected = hashOf(byValues);
    EXPECT_EQ(hashOf({"replay", named}), expected);
    EXPECT_EQ(hashOf({"replay", plain, "--material", "tofu"}), expected);
    EXPECT_NE(hashOf({"replay", plain}), expected);
    const ProgramRun unknown =
        runKerf({"replay", plain, "--out", folder / "no", "--material", "adamant"});
    EXPECT_EQ(unknown.exitCode, 3);
    EXPECT_FALSE(fs::exists(folder / "no"));
}

// kerf score.

using nlohmann::ordered_json;

std::string textOf(const std::string& file) {
    return app::readInputFile(file, 1u << 20);
}

/// Tries of two people, of which the second did not pass.
class ScoreVerb : public ::testing::Test {
  protected:
    ScoreVerb() {
        write("zoe", 25);
        write("ann", 12.5);
    }

    std::string pathOf(const std::string& name) const { return (folder_.path() / name).string(); }
    void write(const std::string& person, double seconds) const {
        app::Task task;
        task.name = "Incision";
        task.person = person;
        app::Score score;
        score.time = seconds;
        if (seconds > 20) {
            score.violations = {"Time: 25.00 s (at most 20.00 s)."};
        }
        fs::create_directories(folder_.path() / person / "run");
        writeText(folder_.path() / person / "run" / "summary.json",
                  ordered_json{{"steps", 3}, {"score", app::toJson(score, task)}}.dump());
    }

    test::TemporaryFolder folder_;
};

TEST_F(ScoreVerb, PrintsATableOfAFolder) {
    const ProgramRun run = runKerf({"score", folder_.path().string()});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(std::ranges::count(run.out, '\n'), 3);
    const std::size_t first = run.out.find("ann/run/summary.json,Incision,ann,");
    const std::size_t second = run.out.find("zoe/run/summary.json,Incision,zoe,");
    EXPECT_LT(first, second) << run.out;
    EXPECT_NE(second, std::string::npos) << run.out;
}

TEST_F(ScoreVerb, WritesFilesAndJson) {
    const ProgramRun run = runKerf({"score", pathOf("ann/run/summary.json"), "--csv",
                                    pathOf("a.csv"), "--html", pathOf("a.html"), "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    const auto printed = ordered_json::parse(run.out);
    ASSERT_EQ(printed["tries"].size(), 1U);
    EXPECT_EQ(printed["tries"][0]["person"], "ann");
    EXPECT_EQ(printed["tries"][0]["time"], 12.5);
    EXPECT_THAT(textOf(pathOf("a.csv")), HasSubstr(",Incision,ann,"));
    EXPECT_THAT(textOf(pathOf("a.html")), HasSubstr("\"person\":\"ann\""));
    const ProgramRun quiet =
        runKerf({"score", pathOf("ann/run/summary.json"), "--csv", pathOf("b.csv")});
    EXPECT_THAT(quiet.out, IsEmpty());
    EXPECT_EQ(textOf(pathOf("a.csv")), textOf(pathOf("b.csv")));
}

TEST_F(ScoreVerb, TakesTheScoreThatLiesBesideASession) {
    app::Session session;
    session.model.builtin = "sphere80";
    session.steps = 1;
    session.task.emplace().name = "Incision";
    session.task->lines = {{{Vec3::Zero(), Vec3::UnitX()}}};
    session.task->person = "eve";
    const std::string file = pathOf("try.kerf.json");
    writeText(file, app::formatSession(session));
    app::Score score;
    score.time = 7;
    writeText(pathOf("try.score.json"), app::toJson(score, *session.task).dump());
    EXPECT_THAT(runKerf({"score", file}).out, HasSubstr("try.kerf.json,Incision,eve,"));
    EXPECT_THAT(runKerf({"score", pathOf("try.score.json")}).out,
                HasSubstr("try.score.json,Incision,eve,"));
    session.task->date = "2026-11-28T10:15:00Z";
    writeText(file, app::formatSession(session));
    EXPECT_EQ(runKerf({"score", file}).exitCode, 3)
        << "of another try: it is run, without a stroke";
}

TEST_F(ScoreVerb, FailsOnRequestWhereATryDidNotPass) {
    EXPECT_EQ(runKerf({"score", folder_.path().string(), "--passed"}).exitCode, 1);
    EXPECT_EQ(runKerf({"score", pathOf("ann"), "--passed"}).exitCode, 0);
    EXPECT_EQ(runKerf({"score", pathOf("zoe")}).exitCode, 0);
}

TEST_F(ScoreVerb, RefusesWhatHasNoScore) {
    EXPECT_EQ(runKerf({"score"}).exitCode, 2);
    const auto refuse = [](const std::string& path, const std::string& words) {
        const ProgramRun run = runKerf({"score", path});
        EXPECT_EQ(run.exitCode, 3) << path;
        EXPECT_THAT(run.errors, HasSubstr(words));
        EXPECT_THAT(run.out, IsEmpty());
    };
    refuse(pathOf("nowhere.json"), "nowhere.json");
    writeText(pathOf("bad.json"), "{");
    refuse(pathOf("bad.json"), "bad.json: ");
    writeText(pathOf("plain.json"), R"({"steps": 3})");
    refuse(pathOf("plain.json"),
           "plain.json: there is no score; give a session (*.kerf.json) with a task");
    writeText(pathOf("ann/bad.kerf.json"), "{");
    refuse(pathOf("ann"), pathOf("ann/bad.kerf.json"));
    fs::create_directories(pathOf("empty"));
    refuse(pathOf("empty"), "empty: there is no session and no summary.json in this folder.");
}

TEST_F(ScoreVerb, WritesOverNothingThatItReadsOrWrites) {
    const std::string summary = pathOf("ann/run/summary.json");
    const std::string before = textOf(summary);
    EXPECT_EQ(runKerf({"score", pathOf(""), "--csv", summary}).exitCode, 3);
    EXPECT_EQ(runKerf({"score", pathOf(""), "--html", summary}).exitCode, 3);
    EXPECT_EQ(textOf(summary), before);
    const std::string both = pathOf("both");
    EXPECT_EQ(runKerf({"score", pathOf(""), "--html", both, "--csv", both}).exitCode, 3);
    EXPECT_FALSE(fs::exists(both));
}

using render::PixelRect;

constexpr int kSide = 64;

class CompareVerb : public testing::Test {
  protected:
    CompareVerb() {
        arguments_.a = write("a.png", 100);
        arguments_.b = write("b.png", 100);
        arguments_.diff = folder_ / "diff.png";
    }
    /// A grey picture, with a brighter square of ten pixels if that has another level.
    fs::path write(const char* name, std::uint8_t level, std::uint8_t square = 0,
                   int height = kSide) {
        render::Image image{kSide, height,
                            std::vector<std::uint8_t>(std::size_t(4) * kSide * height, level)};
        for (int i = 0; i < (square == 0 ? 0 : 400); ++i) {
            const int row = 20 + i / 40;
            image.pixels[std::size_t(4) * (row * kSide + 5) + i % 40] = square;
        }
        for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
            image.pixels[i] = 255;
        }
        writePng(image, folder_ / name);
        return folder_ / name;
    }
    int run() {
        out_.str("");
        return runCompare(arguments_, out_);
    }
    Json report() {
        arguments_.json = true;
        run();
        return Json::parse(out_.str());
    }
    bool wroteDiff() const { return fs::exists(arguments_.diff); }

    test::TemporaryFolder folder_;
    CompareArguments arguments_;
    std::ostringstream out_;
};

TEST_F(CompareVerb, EqualPicturesGiveZeroAndNoDiff) {
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(out_.str(), "equal\n");
    EXPECT_FALSE(wroteDiff());
}

TEST_F(CompareVerb, DifferentPicturesGiveOneAndADiffAndAPlace) {
    write("b.png", 100, 200);
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(out_.str(), StartsWith("differ: "));
    EXPECT_THAT(out_.str(), HasSubstr("of 4096 pixels differ visibly"));
    EXPECT_THAT(out_.str(), testing::ContainsRegex("around x (9|1[0-2]), y 2[3-7],"));
    EXPECT_EQ(render::readPng(arguments_.diff).width, kSide);
}

TEST_F(CompareVerb, WhatNobodySeesIsEqualWithinTheLimitsOnly) {
    write("b.png", 101);
    EXPECT_EQ(run(), 0);
    EXPECT_THAT(out_.str(), StartsWith("equal within the limits: 0 of 4096 pixels"));
    EXPECT_FALSE(wroteDiff());
}

TEST_F(CompareVerb, TolerantLimitsAreWider) {
    write("b.png", 100, 112);
    EXPECT_EQ(report()["equal"], false);
    arguments_.tolerant = true;
    EXPECT_EQ(report()["equal"], true);
    EXPECT_EQ(report()["limits"]["worst"], render::kTolerantLimits.worst);
    write("b.png", 100, 200);
    EXPECT_EQ(report()["equal"], false);
}

TEST_F(CompareVerb, AThresholdForgivesByTheMeanOfTheChannels) {
    write("b.png", 110);
    arguments_.threshold = 0.03;
    EXPECT_EQ(run(), 0) << "10/255 in three of four channels";
    EXPECT_THAT(out_.str(), StartsWith("equal within the threshold: mean difference of a "
                                       "channel 0.0294 (threshold 0.03)"));
    arguments_.threshold = 0;
    EXPECT_EQ(run(), 1);
    EXPECT_TRUE(wroteDiff());
}

TEST_F(CompareVerb, OtherSizeGivesOneAndSaysThatThereIsNoDiff) {
    write("b.png", 100, 0, 30);
    arguments_.threshold = 1;
    EXPECT_EQ(run(), 1);
    EXPECT_EQ(out_.str(),
              "differ in size: 64x64 and 64x30; no picture of the difference is written\n");
    EXPECT_FALSE(wroteDiff());
    EXPECT_EQ(report()["diff"], nullptr);
}

TEST_F(CompareVerb, MasksAreLeftOut) {
    write("b.png", 100, 200);
    arguments_.masks = {{5, 20, 10, 10}};
    EXPECT_EQ(run(), 0);
    EXPECT_EQ(out_.str(), "equal outside the masks\n");
    arguments_.masks = {{5, 20, 10, 5}};
    EXPECT_EQ(run(), 1);
}

TEST_F(CompareVerb, MasksThatMissThePictureOrHideItAreInputErrors) {
    arguments_.masks = {{64, 0, 5, 5}};
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<InputError>(
                                       HasSubstr("--mask 64,0,5,5: this lies outside")));
    arguments_.masks = {{0, 0, 64, 20}, {0, 20, 99, 99}};
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<InputError>(HasSubstr("leave nothing")));
}

TEST(ReadMask, TakesFourWholeNumbersAlone) {
    EXPECT_EQ(readMask("10,0,300,40"), (PixelRect{10, 0, 300, 40}));
    for (const char* text : {"", "1", "1,2,3", "1,2,3,4,5", "1,2,3,4,", "-1,2,3,4", "1,2,0,4",
                             "1,2,3,x", "1, 2,3,4", "1.5,2,3,4", "1,2,3,99999999999"}) {
        EXPECT_EQ(readMask(text), std::nullopt) << text;
    }
}

TEST_F(CompareVerb, NamesThePictureThatItCannotReadOrWrite) {
    write("b.png", 100, 200);
    arguments_.diff = folder_ / "nowhere" / "diff.png";
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<OutputError>(HasSubstr("nowhere")));
    arguments_.b = folder_ / "missing.png";
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<InputError>(HasSubstr("missing.png")));
    EXPECT_EQ(out_.str(), "");
}

TEST_F(CompareVerb, TheDifferenceTakesThePlaceOfNoInputAndNoPipe) {
    arguments_.b = write("b.png", 100, 200);
    arguments_.diff = folder_ / "link.png";
    fs::create_symlink("a.png", arguments_.diff);
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<UsageError>(HasSubstr("link.png")));
    arguments_.diff = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(arguments_.diff.c_str(), 0600), 0);
    EXPECT_THAT([this] { run(); }, testing::ThrowsMessage<OutputError>(HasSubstr("pipe")));
    EXPECT_TRUE(fs::is_fifo(arguments_.diff));
}

TEST_F(CompareVerb, ALinkStaysAndWhatItLeadsToIsReplaced) {
    arguments_.b = write("b.png", 100, 200);
    write("old.png", 7);
    arguments_.diff = folder_ / "link.png";
    fs::create_symlink("old.png", arguments_.diff);
    EXPECT_EQ(run(), 1);
    EXPECT_TRUE(fs::is_symlink(arguments_.diff));
    EXPECT_NE(render::readPng(folder_ / "old.png").pixels[0], 7);
}

TEST_F(CompareVerb, JsonIsOneObjectWithTheKeysOfTheContract) {
    write("b.png", 100, 200);
    const Json json = report();
    EXPECT_EQ(json["equal"], false);
    EXPECT_EQ(json["same_size"], true);
    EXPECT_GE(json["pixels_differing"], 100);
    EXPECT_GT(json["worst"], 0.3);
    EXPECT_LE(json["worst"], 1);
    EXPECT_GT(json["mean"], 0);
    EXPECT_LT(json["mean"], json["worst"]);
    EXPECT_EQ(json["worst_at"].size(), 4U);
    EXPECT_EQ(json["limits"]["pixels"], render::kStrictLimits.pixels);
    EXPECT_EQ(json["differing_pixels"], 100);
    EXPECT_DOUBLE_EQ(json["max_error"], 100 / 255.0);
    EXPECT_EQ(json["threshold"], nullptr);
    EXPECT_EQ(json["diff"], arguments_.diff.string());
}

/// A sphere that has just met the floor, in a small picture.
std::string droppedSphere(double ispcStiffness) {
    return R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
      "params": {"floor": -0.6, "ispc_stiffness": )" +
           std::to_string(ispcStiffness) + R"(}, "steps": 50, "events": [
        {"step": 50, "type": "screenshot", "file": "end.png", "width": 320, "height": 180}]})";
}

TEST(CompareReplays, OfTwoStiffnessesTellsThemApart) {
    const test::TemporaryFolder folder;
    for (const auto& [name, stiffness] : {std::pair{"firm", 0.5}, std::pair{"soft", 0.35}}) {
        writeText(folder / (std::string(name) + ".kerf.json"), droppedSphere(stiffness));
        const ProgramRun replay = runKerf(
            {"replay", folder / (std::string(name) + ".kerf.json"), "--out", folder / name});
        ASSERT_EQ(replay.exitCode, 0) << replay.errors;
    }
    const ProgramRun compared =
        runKerf({"compare", folder / "firm/end.png", folder / "soft/end.png", "--json"});
    EXPECT_EQ(compared.exitCode, 1) << compared.out;
    const Json json = Json::parse(compared.out);
    EXPECT_GT(json["worst"], render::kStrictLimits.worst) << compared.out;
    EXPECT_LT(json["mean_error"], 0.002) << "too little for a mean over all pixels";
}

TEST_F(CompareVerb, APictureThatIsTooLargeIsNotCalledDamaged) {
    writeText(folder_ / "large.png", pngHead(30000, 30000));
    arguments_.a = folder_ / "large.png";
    EXPECT_THAT(inputErrorOf([&] { run(); }), HasSubstr("more than 512 million pixels"));
}

}  // namespace
}  // namespace kerf::app
