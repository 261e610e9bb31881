// kerf sweep, as a person or a cluster calls it.

namespace kerf::app {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

std::vector<std::string> cellsOf(const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream in(row + ",");
    for (std::string cell; std::getline(in, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

class Sweep : public testing::Test {
  protected:
    Sweep() {
        writeText(folder_ / "a.kerf.json", sessionThatDoes(""));
        writeStudy(R"("grid": {"iterations": [2, 3], "ispc_stiffness": [0.5, 1]})");
    }

    void writeStudy(const std::string& keys, const std::string& sessions = R"("a.kerf.json")") {
        writeText(study_, R"({"format": "kerf-sweep", "version": 1, "sessions": [)" + sessions +
                              "], " + keys + "}");
    }
    ProgramRun sweep(const std::string& out, const std::vector<std::string>& options = {},
                     const std::map<std::string, std::string>& environment = {}) {
        std::vector<std::string> words{"sweep", study_, "--out", folder_ / out};
        words.insert(words.end(), options.begin(), options.end());
        return runKerf(words, environment);
    }
    std::string bytes(const std::string& name) { return readBytes(folder_ / name); }
    bool has(const std::string& name) { return fs::exists(folder_ / name); }
    /// The rows of a table, without the two columns that are times.
    std::vector<std::string> rows(const std::string& out) {
        std::vector<std::string> lines = linesOf(bytes(out + "/table.csv"));
        for (std::string& line : lines) {
            line.resize(std::min(line.size(), line.rfind(',', line.rfind(',') - 1)));
        }
        return lines;
    }

    test::TemporaryFolder folder_;
    fs::path study_ = folder_ / "test.json";
};

TEST_F(Sweep, GathersARowForEachRunAndPlots) {
    const ProgramRun run = sweep("out", {"--jobs", "2"});
    ASSERT_EQ(run.exitCode, 0) << run.out << run.errors;
    EXPECT_THAT(run.out, HasSubstr("4 runs, none failed"));
    const auto lines = linesOf(bytes("out/table.csv"));
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_EQ(lines[0],
              "run,session,iterations,ispc_stiffness,exit,state_hash,pieces,volume_mean,"
              "volume_min,volume_final,cut_worst_angle,cut_mean_angle,cut_slivers,"
              "cut_wound_to_swept,cut_volume_error,cut_self_intersections,cut_steps_refused,"
              "tears,fracture_energy,fps_mean,real_time_factor");
    EXPECT_THAT(lines[2], StartsWith("1,a.kerf.json,2,1,0,"));
    for (int number = 0; number < 4; ++number) {
        const auto summary =
            nlohmann::json::parse(bytes("out/" + std::to_string(number) + "/summary.json"));
        const auto cells = cellsOf(lines[std::size_t(number) + 1]);
        ASSERT_EQ(cells.size(), 21u);
        EXPECT_EQ(cells[5], summary["state_hash"].get<std::string>());
        EXPECT_EQ(cells[6], "1");
        EXPECT_EQ(std::stod(cells[8]), summary["volume_ratio"]["min"].get<double>());
        EXPECT_EQ(cells[10], "") << "it was not cut";
        EXPECT_EQ(std::stod(cells[19]), summary["fps"]["mean"].get<double>());
        EXPECT_EQ(std::stod(cells[20]), summary["real_time_factor"]["median"].get<double>());
    }
    for (const char* picture : {"volume.png", "kinetic_energy.png", "frame_time.png"}) {
        const render::Image image = render::readPng(folder_ / "out" / picture);
        EXPECT_GT(image.width, 2 * 300) << "two panels in a row";
        EXPECT_EQ(image.height, 458) << "and two rows, whole";
        EXPECT_THAT(run.out, HasSubstr(picture));
    }
}

TEST_F(Sweep, TheTableHasTheQualityOfTheCuts) {
    writeText(folder_ / "a.kerf.json", sessionThatDoes(R"(
        {"step": 0, "type": "blade", "a": [-0.8, 0.7, 0.02], "b": [0.8, 0.7, 0.02]},
        {"step": 2, "type": "blade", "a": [-0.8, -0.7, 0.02], "b": [0.8, -0.7, 0.02]})"));
    writeStudy(R"("runs": [{"toughness": 50, "tearing": 1}])");
    const ProgramRun run = sweep("out");
    ASSERT_EQ(run.exitCode, 0) << run.out << run.errors;
    const auto lines = linesOf(bytes("out/table.csv"));
    const auto names = cellsOf(lines[0]);
    const auto cells = cellsOf(lines[1]);
    const auto summary = nlohmann::json::parse(bytes("out/0/summary.json"));
    const auto& report = summary.at("cut_report");
    const auto expectCell = [&](const std::string& name, const nlohmann::json& value) {
        const auto place = std::ranges::find(names, name) - names.begin();
        ASSERT_LT(place, std::ssize(cells)) << name;
        EXPECT_EQ(std::stod(cells[place]), value.get<double>()) << name;
    };
    expectCell("cut_worst_angle", report["smallest_angle"]["worst"]);
    expectCell("cut_mean_angle", report["smallest_angle"]["mean"]);
    expectCell("cut_slivers", report["slivers"]["below_0_02"]);
    expectCell("cut_wound_to_swept", report["area"]["wound_to_swept"]);
    expectCell("cut_volume_error", report["volume_error"]);
    expectCell("cut_self_intersections", report["self_intersections"]["pairs"]);
    expectCell("cut_steps_refused", report["steps"]["refused"]);
    expectCell("tears", 0);
    expectCell("fracture_energy", summary["fracture_energy"]);
    EXPECT_NEAR(summary["fracture_energy"].get<double>(),
                50 * report["area"]["swept_at_rest"].get<double>(), 1e-3);
}

TEST_F(Sweep, ARunIsTheReplayWithItsParameters) {
    ASSERT_EQ(sweep("out", {"--run", "3"}).exitCode, 0);
    ASSERT_EQ(runKerf({"replay", folder_ / "a.kerf.json", "--out", folder_ / "replay", "--set",
                       "iterations=3", "--set", "ispc_stiffness=1"})
                  .exitCode,
              0);
    EXPECT_EQ(bytes("out/3/final.ply"), bytes("replay/final.ply"));
    EXPECT_TRUE(has("out/3/metrics.csv"));
    EXPECT_FALSE(has("out/table.csv")) << "a single run gathers nothing";
}

TEST_F(Sweep, SingleRunsInAnyOrderGiveTheSameTable) {
    ASSERT_EQ(sweep("whole").exitCode, 0);
    for (const char* number : {"2", "0", "3", "1"}) {
        EXPECT_EQ(sweep("single", {"--run", number}).exitCode, 0);
    }
    const ProgramRun gathered = sweep("single", {"--gather"});
    EXPECT_EQ(gathered.exitCode, 0) << gathered.errors;
    EXPECT_EQ(rows("single"), rows("whole"));
    EXPECT_EQ(rows("whole").size(), 5u);
}

// They are those of other parameters.
TEST_F(Sweep, PassesOverTheSessionsOwnStateHashes) {
    writeText(folder_ / "a.kerf.json", sessionThatDoes(R"({"step": 2, "type": "check", "hash": ")" +
                                                       std::string(16, '0') + R"("})"));
    EXPECT_EQ(sweep("out", {"--run", "0"}).exitCode, 0);
}

TEST_F(Sweep, RunsThatAreDoneAreNotRunAgain) {
    ASSERT_EQ(sweep("out").exitCode, 0);
    const std::string table = bytes("out/table.csv");
    const ProgramRun again = sweep("out");
    EXPECT_EQ(again.exitCode, 0);
    EXPECT_THAT(again.out, StartsWith("4 runs, none failed"));
    EXPECT_EQ(bytes("out/table.csv"), table) << "with the times of the first run";
    EXPECT_THAT(sweep("out", {"--run", "1"}).out, StartsWith("was done"));
}

/// Starts a sweep, waits until it has done two runs, and kills it.
void killHalfWay(const fs::path& study, const fs::path& out) {
    const std::string script = "'" KERF_BINARY_DIR "/kerf' sweep '" + study.string() + "' --out '" +
                               out.string() +
                               "' --jobs 1 > /dev/null 2>&1 & sweep=$!\n"
                               "while [ ! -e '" +
                               (out / "1").string() +
                               "' ] && kill -0 $sweep; do sleep 0.01; done\n"
                               "kill -9 $sweep";
    ASSERT_EQ(std::system(script.c_str()), 0);
}

TEST_F(Sweep, KilledItGoesOnAndEndsWithTheSameTable) {
    writeText(folder_ / "a.kerf.json", sessionThatDoes("", 100));
    ASSERT_EQ(sweep("whole").exitCode, 0);
    killHalfWay(study_, folder_ / "killed");
    EXPECT_TRUE(has("killed/1"));
    EXPECT_FALSE(has("killed/3"));
    EXPECT_FALSE(has("killed/table.csv")) << "nothing looks finished";
    const std::string before = bytes("killed/1/metrics.csv");
    const ProgramRun resumed = sweep("killed");
    EXPECT_EQ(resumed.exitCode, 0) << resumed.errors;
    EXPECT_THAT(resumed.out, Not(HasSubstr("done    1 ")));
    EXPECT_THAT(resumed.out, HasSubstr("done    3 "));
    EXPECT_EQ(bytes("killed/1/metrics.csv"), before);
    EXPECT_EQ(rows("killed"), rows("whole"));
}

TEST_F(Sweep, GoesOnBehindARunThatFails) {
    writeText(folder_ / "bad.kerf.json", sessionThatDoes(R"({"step": 2, "type": "undo"})"));
    writeText(folder_ / "check.kerf.json",
              sessionThatDoes(R"({"step": 2, "type": "check", "pieces": 7})"));
    writeStudy(R"("runs": [{}])", R"("bad.kerf.json", "check.kerf.json", "a.kerf.json")");
    const ProgramRun run = sweep("out");
    EXPECT_EQ(run.exitCode, 1) << run.out << run.errors;
    EXPECT_THAT(run.out, HasSubstr("failed  0 bad.kerf.json"));
    EXPECT_THAT(run.out, HasSubstr("There is nothing to undo"));
    EXPECT_THAT(run.out, HasSubstr("3 runs, 2 failed (runs 0 and 1)"));
    const auto lines = linesOf(bytes("out/table.csv"));
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines[1], "0,bad.kerf.json,3,,,,,,,,,,,,,,,,");
    EXPECT_THAT(lines[2], StartsWith("1,check.kerf.json,1,")) << "with the results so far";
    EXPECT_THAT(lines[3], StartsWith("2,a.kerf.json,0,"));
    EXPECT_THAT(sweep("out").out, StartsWith("3 runs, 2 failed")) << "they would fail again";
    EXPECT_EQ(sweep("out", {"--run", "0"}).exitCode, 3) << "that of the run";
}

TEST_F(Sweep, RunsWhatChangedAgainAndSaysSo) {
    ASSERT_EQ(sweep("out").exitCode, 0);
    writeStudy(R"("grid": {"iterations": [2, 4], "ispc_stiffness": [0.5, 1]})");
    EXPECT_THAT(sweep("out", {"--list"}).out, HasSubstr("2 a.kerf.json iterations=4 "
                                                        "ispc_stiffness=0.5 missing"));
    EXPECT_EQ(sweep("out", {"--gather"}).exitCode, 1) << "results of another run are none";
    const ProgramRun changed = sweep("out");
    EXPECT_EQ(changed.exitCode, 0);
    EXPECT_THAT(changed.errors, HasSubstr("Run 2 is run again: its parameters changed."));
    EXPECT_THAT(changed.errors, HasSubstr("Run 3 is run again"));
    EXPECT_THAT(changed.out, Not(HasSubstr("done    0 ")));
    writeText(folder_ / "a.kerf.json", sessionThatDoes("", 6));
    EXPECT_THAT(sweep("out").errors, HasSubstr("Run 0 is run again: its session changed."));
    EXPECT_EQ(linesOf(bytes("out/0/metrics.csv")).size(), 7u);
}

TEST_F(Sweep, GatheringRunsNothingAndNamesWhatIsMissing) {
    ASSERT_EQ(sweep("out", {"--run", "2"}).exitCode, 0);
    const ProgramRun gathered = sweep("out", {"--gather"});
    EXPECT_EQ(gathered.exitCode, 1);
    EXPECT_THAT(gathered.out, HasSubstr("3 missing (runs 0, 1 and 3)"));
    EXPECT_FALSE(has("out/0"));
    const auto lines = linesOf(bytes("out/table.csv"));
    EXPECT_EQ(lines[1], "0,a.kerf.json,2,0.5,,,,,,,,,,,,,,,,,");
    EXPECT_THAT(lines[3], StartsWith("2,a.kerf.json,3,0.5,0,"));
}

TEST_F(Sweep, WhatWasDamagedSinceCountsAsMissingAndIsRunAgain) {
    ASSERT_EQ(sweep("out").exitCode, 0);
    const std::vector<std::string> whole = rows("out");
    const std::string metrics = bytes("out/1/metrics.csv");
    writeText(folder_ / "out/0/summary.json", "garbage");
    writeText(folder_ / "out/1/metrics.csv", metrics.substr(0, metrics.size() - 4));
    writeText(folder_ / "out/3/run.json", "");
    const ProgramRun gathered = sweep("out", {"--gather"});
    EXPECT_EQ(gathered.exitCode, 1);
    EXPECT_THAT(gathered.out, StartsWith("4 runs, 3 missing (runs 0, 1 and 3)\n"));
    for (const char* file : {"0/summary.json", "1/metrics.csv", "3/run.json"}) {
        EXPECT_THAT(gathered.errors, HasSubstr((folder_ / "out" / file).string() + " is damaged."));
    }
    EXPECT_EQ(rows("out")[3], whole[3]);
    const ProgramRun again = sweep("out");
    EXPECT_EQ(again.exitCode, 0) << again.out << again.errors;
    EXPECT_THAT(again.out, Not(HasSubstr("done    2 ")));
    EXPECT_EQ(rows("out"), whole);
}

TEST_F(Sweep, AFolderOfSomebodyElseStaysWhateverItsRecordSays) {
    for (const char* folder : {"out/1", "out/2"}) {
        fs::create_directories(folder_ / folder);
        writeText(folder_ / folder / "precious.txt", "mine");
    }
    writeText(folder_ / "out/1/run.json", R"({"my": 1})");
    const ProgramRun run = sweep("out");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.out, HasSubstr("out/1: there is something else than a run of a sweep"));
    EXPECT_THAT(run.out, HasSubstr("missing 2 a.kerf.json"));
    EXPECT_THAT(run.out, HasSubstr("4 runs, 2 missing (runs 1 and 2)\n"));
    EXPECT_EQ(bytes("out/1/run.json"), R"({"my": 1})");
    for (const char* file : {"out/1/precious.txt", "out/2/precious.txt"}) {
        EXPECT_EQ(bytes(file), "mine");
    }
    EXPECT_TRUE(has("out/3/summary.json")) << "the others were run";
}

TEST_F(Sweep, WhatWouldStopEachRunIsToldOnceAndBefore) {
    fs::create_directories(folder_ / "table/table.csv");
    fs::create_directories(folder_ / "lock/.lock");
    for (const char* out : {"a.kerf.json/x", "table", "lock"}) {
        const ProgramRun run = sweep(out);
        EXPECT_EQ(run.exitCode, 5) << out << run.out << run.errors;
        EXPECT_EQ(linesOf(run.errors).size(), 1u) << run.errors;
        EXPECT_EQ(run.out, "") << out;
    }
    EXPECT_FALSE(has("table/0"));
    EXPECT_FALSE(has("lock/0"));
}

TEST_F(Sweep, AParameterOfAModelThatIsNotThereIsToldBefore) {
    writeStudy(R"("grid": {"density@1": [50]})");
    const ProgramRun run = runKerf({"sweep", study_, "--list"});
    EXPECT_EQ(run.exitCode, 3) << run.out;
    EXPECT_THAT(run.errors, HasSubstr("density@1: a.kerf.json has no model 1, only 1 model"));
}

TEST_F(Sweep, NamesMayBeginWithADash) {
    writeText(folder_ / "-a.kerf.json", sessionThatDoes(""));
    writeText(folder_ / "-study.json", R"({"format": "kerf-sweep", "version": 1,
                                           "sessions": ["-a.kerf.json"], "runs": [{}]})");
    const std::string script = "cd '" + folder_.path().string() +
                               "' && '" KERF_BINARY_DIR
                               "/kerf' sweep --out=-out -- -study.json > log 2>&1";
    EXPECT_EQ(WEXITSTATUS(std::system(script.c_str())), 0) << bytes("log");
    EXPECT_TRUE(has("-out/0/final.ply"));
}

TEST_F(Sweep, WithNothingDoneThereIsNothingToGather) {
    const ProgramRun none = sweep("out", {"--gather"});
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_EQ(none.out, "4 runs, 4 missing (runs 0, 1, 2 and 3); there is nothing to gather\n");
    EXPECT_FALSE(has("out"));
    fs::create_directory(folder_ / "out");
    writeText(folder_ / "out/table.csv", "old");
    EXPECT_EQ(sweep("out", {"--gather"}).exitCode, 1);
    EXPECT_EQ(bytes("out/table.csv"), "old");
}

TEST_F(Sweep, ListsItsRuns) {
    EXPECT_THAT(linesOf(runKerf({"sweep", study_, "--list"}).out),
                ElementsAre("0 a.kerf.json iterations=2 ispc_stiffness=0.5",
                            "1 a.kerf.json iterations=2 ispc_stiffness=1",
                            "2 a.kerf.json iterations=3 ispc_stiffness=0.5",
                            "3 a.kerf.json iterations=3 ispc_stiffness=1"));
    ASSERT_EQ(sweep("out", {"--run", "1"}).exitCode, 0);
    const auto json = nlohmann::json::parse(sweep("out", {"--list", "--json"}).out);
    ASSERT_EQ(json["runs"].size(), 4u);
    EXPECT_EQ(json["runs"][1]["state"], "done");
    EXPECT_EQ(json["runs"][2]["state"], "missing");
    EXPECT_EQ(json["runs"][2]["params"]["iterations"], 3);
}

TEST_F(Sweep, VectorsAndWordsStandInOneCell) {
    writeStudy(R"("runs": [{"gravity": [0, -1, 0], "solver": "pbd", "floor": null}])");
    ASSERT_EQ(sweep("out").exitCode, 0);
    EXPECT_THAT(linesOf(bytes("out/table.csv"))[1],
                StartsWith(R"(0,a.kerf.json,"[0, -1, 0]",pbd,null,0,)"));
}

TEST_F(Sweep, SeveralProgramsMayDoTheSameRun) {
    std::vector<ProgramRun> runs(3);
    std::vector<std::thread> threads;
    threads.reserve(runs.size());
    for (ProgramRun& run : runs) {
        threads.emplace_back([&] { run = sweep("out", {"--run", "0"}); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const ProgramRun& run : runs) {
        EXPECT_EQ(run.exitCode, 0) << run.errors;
    }
    EXPECT_EQ(std::ranges::count_if(
                  runs, [](const ProgramRun& run) { return run.out.starts_with("was done"); }),
              2);
    EXPECT_TRUE(has("out/0/run.json"));
}

TEST_F(Sweep, LinksInTheFolderOfResultsLeadNowhere) {
    writeStudy(R"("runs": [{}])");
    for (const char* name : {"0", ".0.part", ".lock", "table.csv"}) {
        fs::remove_all(folder_ / "out");
        fs::create_directories(folder_ / "out");
        fs::create_directories(folder_ / "elsewhere");
        writeText(folder_ / "elsewhere/mine.txt", "mine");
        const bool isFolder = std::string(name).find('0') != std::string::npos;
        fs::create_symlink(folder_ / (isFolder ? "elsewhere" : "elsewhere/mine.txt"),
                           folder_ / "out" / name);
        sweep("out");
        EXPECT_EQ(bytes("elsewhere/mine.txt"), "mine") << name;
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "elsewhere"), {}), 1) << name;
    }
    fs::remove_all(folder_ / "out");
    fs::create_directories(folder_ / "out");
    fs::create_symlink(folder_ / "made", folder_ / "out/.lock");
    sweep("out");
    EXPECT_FALSE(has("made"));
}

/// A program in Kerf's place that a signal ends.
class CrashingProgram {
  public:
    explicit CrashingProgram(fs::path file) : file_(std::move(file)) {
        writeText(file_, "#!/bin/sh\nkill -SEGV $$\n");
        fs::permissions(file_, fs::perms::owner_all);
    }
    std::map<std::string, std::string> environment() const {
        return {{"KERF_EXECUTABLE", file_.string()}};
    }

  private:
    fs::path file_;
};

TEST_F(Sweep, ARunThatCrashedIsTriedAgain) {
    const CrashingProgram crashing(folder_ / "crashing");
    EXPECT_EQ(sweep("out", {"--run", "0"}, crashing.environment()).exitCode, 128 + SIGSEGV);
    EXPECT_EQ(sweep("out", {"--gather"}).exitCode, 1);
    EXPECT_THAT(linesOf(bytes("out/table.csv"))[1], StartsWith("0,a.kerf.json,2,0.5,139,"));
    const ProgramRun again = sweep("out");
    EXPECT_EQ(again.exitCode, 0) << again.out;
    EXPECT_THAT(again.errors, HasSubstr("Run 0 is run again: it was ended by signal 11."));
}

TEST_F(Sweep, WithoutOpenGlThatIsSaidAndNothingIsRecorded) {
    const ProgramRun run = sweep("out", {}, {{"KERF_FORCE_NO_GL", "1"}});
    EXPECT_EQ(run.exitCode, 4);
    EXPECT_FALSE(has("out/0"));
    ASSERT_EQ(sweep("out").exitCode, 0);
    const ProgramRun gathered = sweep("out", {"--gather"}, {{"KERF_FORCE_NO_GL", "1"}});
    EXPECT_EQ(gathered.exitCode, 0) << "a login node needs none";
    EXPECT_THAT(gathered.errors, HasSubstr("The plots were not drawn."));
    EXPECT_FALSE(has("out/volume.png")) << "an older one";
    EXPECT_TRUE(has("out/table.csv"));
}

TEST_F(Sweep, MistakesAreOneSentence) {
    const std::string text = study_.string();
    const std::string out = folder_ / "out";
    const std::vector<std::pair<std::vector<std::string>, int>> calls{
        {{"sweep"}, 2},
        {{"sweep", text}, 2},
        {{"sweep", text, "--out", out, "--run", "4"}, 2},
        {{"sweep", text, "--out", out, "--run", "-1"}, 2},
        {{"sweep", text, "--out", out, "--jobs", "0"}, 2},
        {{"sweep", text, "--out", out, "--run", "1", "--gather"}, 2},
        {{"sweep", text, "--out", out, "--list", "--gather"}, 2},
        {{"sweep", folder_ / "missing.json", "--out", out}, 3},
        {{"sweep", folder_ / "a.kerf.json", "--out", out}, 3},
        {{"sweep", text, "--out", text}, 3},
        {{"replay", folder_ / "a.kerf.json", "--out", text}, 3},
    };
    for (const auto& [words, exitCode] : calls) {
        const ProgramRun run = runKerf(words);
        EXPECT_EQ(run.exitCode, exitCode) << run.errors;
        EXPECT_EQ(linesOf(run.errors).size(), 1u) << run.errors;
        EXPECT_EQ(run.out, "");
    }
    EXPECT_FALSE(has("out"));
}

}  // namespace
}  // namespace kerf::app
