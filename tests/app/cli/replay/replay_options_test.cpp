#include "app/journal/journal.h"

namespace kerf::app {
namespace {

using testing::ContainsRegex;

class ReplayVerbOptions : public testing::Test {
  protected:
    ReplayVerbOptions() { writeText(folder_ / "test.kerf.json", smallSession()); }

    /// Replays the session into the folder `out`.
    ProgramRun replay(const std::string& out, const std::vector<std::string>& options,
                      const std::map<std::string, std::string>& environment = {}) {
        std::vector<std::string> words{"replay", folder_ / "test.kerf.json", "--out",
                                       folder_ / out};
        words.insert(words.end(), options.begin(), options.end());
        return runKerf(words, environment);
    }
    Json summary(const std::string& out) {
        return Json::parse(readBytes(folder_ / (out + "/summary.json")));
    }
    std::string path(const std::string& name) { return folder_ / name; }

    test::TemporaryFolder folder_;
};

TEST_F(ReplayVerbOptions, SetReplacesAParameterAtTheStart) {
    ASSERT_EQ(replay("a", {}).exitCode, 0);
    ASSERT_EQ(replay("b", {"--set", "ispc_stiffness=0.25", "--set", "solver=pbd"}).exitCode, 0);
    ASSERT_EQ(replay("c", {"--set", "gravity=[0, 0, 0]"}).exitCode, 0);
    EXPECT_NE(summary("a")["state_hash"], summary("b")["state_hash"]);
    EXPECT_EQ(summary("a")["state_hash"], summary("c")["state_hash"]) << "as it was";
}

TEST_F(ReplayVerbOptions, SetRefusesWhatIsNoParameterOrValue) {
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {"ispc_stifness=0.2", "there is no parameter \"ispc_stifness\""},
        {"ispc_stiffness=2", "ispc_stiffness"},
        {"density=abc", "takes one number from 10 to 20000 kg/m^3; see kerf --help."},
        {"iterations=abc", "takes one number from 1 to 60, or \"auto\"; see kerf --help."},
        {"ispc_stiffness=[1", "ispc_stiffness"},
        {"ispc_stiffness=", "ispc_stiffness"},
        {"gravity=3", "gravity"},
        {"solver=fem", "solver"},
        {"iterations", "expected NAME=VALUE"},
    };
    for (const auto& [setting, words] : mistakes) {
        const ProgramRun run = replay("out", {"--set", setting});
        EXPECT_EQ(run.exitCode, 2) << setting;
        EXPECT_THAT(run.errors, HasSubstr(words)) << setting;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    }
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(ReplayVerbOptions, NothingThatIsReadIsWrittenOver) {
    ASSERT_EQ(replay("ref", {}).exitCode, 0);
    fs::create_directories(folder_ / "out/diff");
    fs::create_directories(folder_ / "own");
    fs::copy(folder_ / "ref/end.png", folder_ / "out/diff/end.png");
    fs::copy(folder_ / "ref/final.ply", folder_ / "own/final.ply");
    writeText(folder_ / "own/summary.json", smallSession());
    writeText(folder_ / "own/own.kerf.json",
              R"({"format": "kerf-session", "version": 1, "model": {"path": "final.ply"},
                  "steps": 2})");
    const std::string mesh = readBytes(folder_ / "own/final.ply");
    const std::string picture = readBytes(folder_ / "ref/end.png");

    expectEnd(replay("ref", {"--reference", path("ref")}), 2,
              "ref/pictures/half.png and would write over");
    expectEnd(replay("ref/../ref", {"--reference", path("ref")}), 2, "would write over");
    expectEnd(replay("out", {"--reference", path("out/diff")}), 2, "would write over");
    expectEnd(runKerf({"replay", path("own/own.kerf.json"), "--out", path("own")}), 2,
              "own/final.ply and would write over");
    expectEnd(runKerf({"replay", path("own/summary.json"), "--out", path("own")}), 2,
              "own/summary.json and would write over");
    writeText(folder_ / "own/pieces.kerf.json",
              R"({"format": "kerf-session", "version": 1, "model": {"path": "e-7.ply"}, "steps": 2,
                  "events": [{"step": 2, "type": "export", "file": "e.ply", "per_piece": true}]})");
    fs::copy(folder_ / "own/final.ply", folder_ / "own/e-7.ply");
    expectEnd(runKerf({"replay", path("own/pieces.kerf.json"), "--out", path("own")}), 2,
              "own/e-7.ply and would write over");
    expectEnd(replay("new", {"--strip", path("new/end.png"), "3"}), 2, "another result");
    EXPECT_EQ(readBytes(folder_ / "own/final.ply"), mesh);
    EXPECT_EQ(readBytes(folder_ / "own/summary.json"), smallSession());
    EXPECT_EQ(readBytes(folder_ / "ref/end.png"), picture);
    EXPECT_EQ(readBytes(folder_ / "out/diff/end.png"), picture);
    EXPECT_FALSE(fs::exists(folder_ / "new"));
    EXPECT_EQ(replay("other", {"--reference", path("ref")}).exitCode, 0);
}

TEST_F(ReplayVerbOptions, WithoutStandardStreamsTheirTextReachesNoFile) {
    const std::string script = "'" KERF_BINARY_DIR "/kerf' replay '" + path("test.kerf.json") +
                               "' --hashes --out '" + path("out") + "' <&- >&- 2>&-";
    EXPECT_EQ(WEXITSTATUS(std::system(script.c_str())), 5) << "nobody got what it printed";
    ASSERT_EQ(replay("usual", {"--hashes"}).exitCode, 0);
    EXPECT_EQ(readBytes(folder_ / "out/hashes.csv"), readBytes(folder_ / "usual/hashes.csv"));
    EXPECT_THAT(readBytes(folder_ / "out/metrics.csv"), StartsWith("step,"));
}

TEST_F(ReplayVerbOptions, UntilEndsInTheStateOfTheWholeRunAtThatStep) {
    ASSERT_EQ(replay("all", {"--hashes"}).exitCode, 0);
    ASSERT_EQ(replay("some", {"--hashes", "--until", "9"}).exitCode, 0);
    const CsvTable all(folder_ / "all/hashes.csv", 1 << 20);
    const CsvTable some(folder_ / "some/hashes.csv", 1 << 20);
    ASSERT_EQ(all.rows(), 40u);
    ASSERT_EQ(some.rows(), 9u);
    for (std::size_t row = 0; row < some.rows(); ++row) {
        EXPECT_EQ(some.cell(row, 1), all.cell(row, 1)) << "also between two keys of the blade";
    }
    EXPECT_EQ(summary("some")["state_hash"], some.cell(8, 1));
    EXPECT_EQ(summary("some")["steps"], 9);
    EXPECT_TRUE(fs::exists(folder_ / "some/pictures/half.png"));
    EXPECT_FALSE(fs::exists(folder_ / "some/end.png"));
    EXPECT_EQ(replay("out", {"--until", "0"}).exitCode, 2);
}

TEST_F(ReplayVerbOptions, FinePicturesAreOnlyTakenOnDemand) {
    ASSERT_EQ(replay("light", {"--until", "9"}).exitCode, 0);
    ASSERT_EQ(replay("again", {"--until", "9"}).exitCode, 0);
    ASSERT_EQ(replay("fine", {"--until", "9", "--fine"}).exitCode, 0);
    const auto picture = [&](const std::string& out) {
        return readBytes(folder_ / (out + "/pictures/half.png"));
    };
    EXPECT_EQ(picture("again"), picture("light"));
    EXPECT_NE(picture("fine"), picture("light"));
}

TEST_F(ReplayVerbOptions, AnEnvironmentThatIsNoPanoramaIsToldAndTheLightIsEven) {
    ASSERT_EQ(replay("studio", {"--until", "9"}).exitCode, 0);
    const ProgramRun run =
        replay("even", {"--until", "9"}, {{"KERF_ENVIRONMENT", path("test.kerf.json")}});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.errors + run.out, HasSubstr("test.kerf.json: this is no panorama"));
    EXPECT_THAT(run.errors + run.out, HasSubstr("The light is even instead."));
    EXPECT_NE(readBytes(folder_ / "even/pictures/half.png"),
              readBytes(folder_ / "studio/pictures/half.png"));
}

TEST_F(ReplayVerbOptions, JsonLinesHaveTheColumnsOfTheMetrics) {
    const ProgramRun run = replay("out", {"--jsonl"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    const CsvTable metrics(folder_ / "out/metrics.csv", 1 << 20);
    const std::string table = readBytes(folder_ / "out/metrics.csv");
    const auto columns = 1 + std::ranges::count(table.substr(0, table.find('\n')), ',');
    std::istringstream lines(run.out);
    std::size_t row = 0;
    for (std::string line; std::getline(lines, line); ++row) {
        const auto json = Json::parse(line);
        for (const auto& item : json.items()) {
            const std::size_t column = metrics.require(item.key());
            const std::string& cell = metrics.cell(row, column);
            const auto expected = cell.empty() ? Json() : Json::parse(cell);
            EXPECT_EQ(item.value().dump(), expected.dump()) << item.key();
        }
        EXPECT_EQ(std::ssize(json), columns);
    }
    EXPECT_EQ(row, 40u);
    EXPECT_EQ(replay("out", {"--jsonl", "--json"}).exitCode, 2);
}

TEST_F(ReplayVerbOptions, PiecesSumUpToTheVolume) {
    ASSERT_EQ(replay("out", {"--pieces"}).exitCode, 0);
    const CsvTable metrics(folder_ / "out/metrics.csv", 1 << 20);
    const CsvTable pieces(folder_ / "out/pieces.csv", 1 << 20);
    std::vector<double> volumes(metrics.rows());
    std::vector<double> counts(metrics.rows());
    for (std::size_t row = 0; row < pieces.rows(); ++row) {
        const auto step = static_cast<std::size_t>(pieces.number(row, pieces.require("step")));
        volumes[step] += pieces.number(row, pieces.require("volume"));
        EXPECT_EQ(pieces.number(row, pieces.require("piece")), counts[step]++);
        EXPECT_LT(pieces.number(row, pieces.require("low_y")),
                  pieces.number(row, pieces.require("high_y")));
    }
    for (std::size_t step = 0; step < metrics.rows(); ++step) {
        EXPECT_NEAR(volumes[step], metrics.number(step, metrics.require("volume")), 1e-9);
        EXPECT_EQ(counts[step], metrics.number(step, metrics.require("pieces")));
    }
}

TEST_F(ReplayVerbOptions, VerifyNamesTheFirstStepAndThePartAndEndsThere) {
    ASSERT_EQ(replay("first", {"--hashes"}).exitCode, 0);
    const std::string hashes = path("first/hashes.csv");
    EXPECT_EQ(replay("same", {"--verify", hashes}, {{"LP_NUM_THREADS", "1"}}).exitCode, 0);

    const ProgramRun other = replay("other", {"--verify", hashes, "--set", "friction=0.75"});
    expectEnd(other, 1, "Step 0: the replay has diverged from " + hashes + " in parameters.");
    EXPECT_EQ(summary("other")["steps"], 1) << "it goes no further";
    EXPECT_EQ(summary("other")["failures"].size(), 1u);

    const ProgramRun whole =
        replay("whole", {"--verify", hashes, "--set", "friction=0.75", "--keep-going"});
    EXPECT_EQ(whole.exitCode, 1);
    EXPECT_EQ(summary("whole")["steps"], 40) << "unless it is asked to";
    EXPECT_EQ(summary("whole")["failures"].size(), 1u) << "what follows is not told";
}

TEST_F(ReplayVerbOptions, VerifySeesABladeThatCutsTheSame) {
    ASSERT_EQ(replay("first", {"--hashes"}).exitCode, 0);
    std::string session = smallSession();
    const std::string lift = "0.8, -0.72, 0.05";
    session.replace(session.find(lift), lift.size(), "0.8, -0.73, 0.05");
    writeText(folder_ / "test.kerf.json", session);
    const ProgramRun run = replay("out", {"--verify", path("first/hashes.csv")});
    expectEnd(run, 1, "Step 2: ");
    EXPECT_THAT(run.errors, HasSubstr("blade"));
}

TEST_F(ReplayVerbOptions, VerifyTakesTheColumnsThatThereAre) {
    ASSERT_EQ(replay("first", {"--hashes"}).exitCode, 0);
    const CsvTable full(folder_ / "first/hashes.csv", 1 << 20);
    std::string text = "step,state_hash,topology_hash,mood\n";
    for (std::size_t row = 0; row < full.rows(); ++row) {
        const bool altered = row == 20;
        text += full.cell(row, 0) + "," + (altered ? "0123456789abcdef" : full.cell(row, 1)) + "," +
                full.cell(row, 2) + ",good\n";
    }
    writeText(folder_ / "short.csv", text);
    const ProgramRun run = replay("out", {"--verify", path("short.csv")});
    expectEnd(run, 1, "Step 20: ");
    EXPECT_THAT(run.errors, HasSubstr("in positions or velocities or boxes."));
}

TEST_F(ReplayVerbOptions, VerifyComparesHowLongTheRunsAre) {
    ASSERT_EQ(replay("first", {"--hashes"}).exitCode, 0);
    const std::string text = readBytes(folder_ / "first/hashes.csv");
    const std::size_t lastRow = text.rfind('\n', text.size() - 2);
    writeText(folder_ / "shorter.csv", text.substr(0, lastRow + 1));
    writeText(folder_ / "longer.csv", text + "40" + text.substr(text.find(',', lastRow)));
    const ProgramRun shorter = replay("out", {"--verify", path("shorter.csv")});
    expectEnd(shorter, 1, "Step 39: ");
    EXPECT_THAT(shorter.errors, HasSubstr("ends before this step"));
    const ProgramRun longer = replay("out", {"--verify", path("longer.csv")});
    expectEnd(longer, 1, "goes on to step 40");
    EXPECT_EQ(replay("out", {"--verify", path("longer.csv"), "--until", "12"}).exitCode, 0);
}

TEST_F(ReplayVerbOptions, VerifyRefusesWhatHoldsNoHashes) {
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {"", "empty"},
        {"step,state_hash\n0,0123456789abcdef\n", "topology_hash"},
        {"step,state_hash,topology_hash\n0,0123456789abcdef\n", "line 2: expected 3 cells"},
        {"step,state_hash,topology_hash\n1,0123456789abcdef,0123456789abcdef\n",
         "line 2: expected step 0"},
        {"step,state_hash,topology_hash\n0,0123456789abcdef,x\n", "line 2: 'x' is no hash"},
    };
    for (const auto& [text, words] : mistakes) {
        writeText(folder_ / "wrong.csv", text);
        const ProgramRun run = replay("out", {"--verify", path("wrong.csv")});
        EXPECT_EQ(run.exitCode, 3) << text;
        EXPECT_THAT(run.errors, HasSubstr(words));
    }
    EXPECT_EQ(replay("out", {"--verify", path("missing.csv")}).exitCode, 3);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(ReplayVerbOptions, HashesDoNotWriteOverWhatTheyAreComparedWith) {
    ASSERT_EQ(replay("out", {"--hashes"}).exitCode, 0);
    const std::string before = readBytes(folder_ / "out/hashes.csv");
    EXPECT_EQ(replay("out", {"--verify", path("out/hashes.csv")}).exitCode, 0);
    EXPECT_EQ(readBytes(folder_ / "out/hashes.csv"), before);
    EXPECT_EQ(replay("out", {"--hashes", "--verify", path("out/hashes.csv")}).exitCode, 2);
    EXPECT_EQ(readBytes(folder_ / "out/hashes.csv"), before);
}

TEST_F(ReplayVerbOptions, FramesHoldNoPicturesAndFiles) {
    ASSERT_EQ(replay("out", {}).exitCode, 0);
    const CsvTable metrics(folder_ / "out/metrics.csv", 1 << 20);
    const std::size_t frame = metrics.require("frame_ms");
    const std::size_t render = metrics.require("render_ms");
    // The first picture compiles its shaders, so it takes longer than any step of this session.
    EXPECT_GT(metrics.number(8, render), 0);
    double slowest = 0;
    for (std::size_t row = 0; row < metrics.rows(); ++row) {
        EXPECT_EQ(metrics.number(row, render) > 0, row == 8);
        EXPECT_GE(metrics.number(row, frame), 0);
        slowest = std::max(slowest, metrics.number(row, frame));
    }
    EXPECT_EQ(summary("out")["fps"]["min"], 1000 / slowest);
}

TEST_F(ReplayVerbOptions, TellsTheRealTimeFactor) {
    const ProgramRun run = replay("out", {});
    ASSERT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, ContainsRegex("\ntime: 0.2 s simulated in .*x real time \\(slowest step "
                                       ".*x\\), .*x with pictures\n$"));
    const CsvTable metrics(folder_ / "out/metrics.csv", 1 << 20);
    const std::size_t frame = metrics.require("frame_ms");
    const std::size_t column = metrics.require("real_time_factor");
    double least = metrics.number(0, column);
    for (std::size_t row = 0; row < metrics.rows(); ++row) {
        const double factor = metrics.number(row, column);
        EXPECT_DOUBLE_EQ(factor, 1000 * 0.005 / metrics.number(row, frame));
        least = std::min(least, factor);
    }
    const auto factors = summary("out")["real_time_factor"];
    EXPECT_EQ(factors["worst"], least);
    EXPECT_LE(factors["worst"], factors["median"]);
    EXPECT_GT(factors["with_drawing"], 0);
}

TEST_F(ReplayVerbOptions, NoFactorWhileTimeIsPaused) {
    writeText(folder_ / "test.kerf.json",
              sessionThatDoes(R"({"step": 1, "type": "hold"}, {"step": 4, "type": "run"})"));
    ASSERT_EQ(replay("out", {}).exitCode, 0);
    const CsvTable metrics(folder_ / "out/metrics.csv", 1 << 20);
    for (std::size_t row = 0; row < metrics.rows(); ++row) {
        EXPECT_EQ(metrics.cell(row, metrics.require("real_time_factor")).empty(),
                  row >= 1 && row < 4);
    }
    writeText(folder_ / "test.kerf.json", sessionThatDoes(R"({"step": 0, "type": "hold"})"));
    const ProgramRun paused = replay("out", {});
    EXPECT_THAT(paused.out, HasSubstr("time: none was simulated"));
    EXPECT_TRUE(summary("out")["real_time_factor"]["median"].is_null());
}

TEST_F(ReplayVerbOptions, ReferenceComparesPicturesAndUpdateRenewsThem) {
    const std::vector<std::string> options{"--reference", path("ref")};
    const ProgramRun none = replay("out", options);
    expectEnd(none, 1, "end.png: there is no such picture");
    EXPECT_FALSE(fs::exists(folder_ / "ref"));

    std::vector<std::string> update = options;
    update.emplace_back("--update");
    EXPECT_EQ(replay("out", update).exitCode, 0);
    EXPECT_EQ(readBytes(folder_ / "ref/pictures/half.png"),
              readBytes(folder_ / "out/pictures/half.png"));
    EXPECT_EQ(replay("out", options).exitCode, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/diff"));

    render::Image spoiled = render::readPng(folder_ / "ref/end.png");
    std::fill_n(spoiled.pixels.begin(), 96 * 4 * 32, 0);
    writePng(spoiled, folder_ / "ref/end.png");
    const ProgramRun other = replay("out", options);
    expectEnd(other, 1, "end.png differs in ");
    EXPECT_TRUE(fs::exists(folder_ / "out/diff/end.png"));
    EXPECT_FALSE(fs::exists(folder_ / "out/diff/pictures"));
    EXPECT_EQ(replay("out", {"--update"}).exitCode, 2);
}

TEST_F(ReplayVerbOptions, ReferenceLeavesOutWhatComesBehindUntil) {
    const std::vector<std::string> options{"--until", "11", "--reference", path("ref")};
    std::vector<std::string> update = options;
    update.emplace_back("--update");
    const ProgramRun made = replay("out", update);
    EXPECT_EQ(made.exitCode, 0) << made.errors;
    EXPECT_THAT(made.out, HasSubstr("written to " + path("ref") + ": pictures/half.png\n"));
    EXPECT_FALSE(fs::exists(folder_ / "ref/end.png"));
    const ProgramRun same = replay("out", options);
    EXPECT_EQ(same.exitCode, 0);
    EXPECT_THAT(same.errors, Not(HasSubstr("compares nothing")));
    fs::remove(folder_ / "ref/pictures/half.png");
    update.emplace_back("--json");
    EXPECT_EQ(Json::parse(replay("out", update).out)["renewed"][0], "pictures/half.png");
}

TEST_F(ReplayVerbOptions, AJournalIsReplayedLikeTheSessionThatItKeeps) {
    Session whole = readSession(folder_ / "test.kerf.json");
    const std::vector<SessionEvent> events = std::exchange(whole.events, {});
    fs::path journal;
    {
        Journal left(folder_ / "journals");
        left.begin("left", whole, {0, {events.begin(), events.end()}, whole.steps}, true);
        journal = left.file();
    }
    EXPECT_EQ(replay("out", {}).exitCode, 0);
    const ProgramRun left = runKerf({"replay", journal, "--out", folder_ / "left"});
    EXPECT_EQ(left.exitCode, 0) << left.errors;
    EXPECT_EQ(summary("left")["state_hash"], summary("out")["state_hash"]);
}

TEST_F(ReplayVerbOptions, AReferenceThatComparesNothingSaysSo) {
    const ProgramRun run = replay("out", {"--until", "1", "--reference", path("ref")});
    expectEnd(run, 0, "compares nothing: this replay takes no screenshot");
}

TEST_F(ReplayVerbOptions, ACheckThatFailsEndsTheRun) {
    writeText(folder_ / "test.kerf.json",
              smallSession(R"(, {"step": 20, "type": "check", "pieces": 5},
                                {"step": 30, "type": "check", "pieces": 6})"));
    const ProgramRun run = replay("out", {});
    expectEnd(run, 1, "Step 20: ");
    EXPECT_THAT(run.errors, HasSubstr("--keep-going"));
    EXPECT_EQ(summary("out")["steps"], 20);
    EXPECT_EQ(replay("out", {"--keep-going"}).exitCode, 1);
    EXPECT_EQ(summary("out")["steps"], 40);
    EXPECT_EQ(summary("out")["failures"].size(), 2u);
}

}  // namespace
}  // namespace kerf::app
