#include "sim/base/params.h"

namespace kerf::app {
namespace {

/// The exit code is `code` and standard error one sentence that contains `words`.
void expectMistake(const ProgramRun& run, int code, const std::string& words) {
    EXPECT_EQ(run.exitCode, code) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_NE(run.errors.find(words), std::string::npos) << run.errors;
}

/// A box that lacks one triangle, as the text of an OBJ file.
std::string openBox() {
    TriangleSoup soup = boxSoup();
    soup.triangles.pop_back();
    return objText(soup);
}

/// Verbs for people, as `kerf --help` lists them.
std::vector<std::string> verbs() {
    const std::string help = runKerf({"--help"}).out;
    const std::string list = help.substr(help.find("Subcommands:"));
    static const std::regex kRow("\n  ([a-z-]+) ");
    std::vector<std::string> names;
    for (std::sregex_iterator row(list.begin(), list.end(), kRow), end; row != end; ++row) {
        names.push_back((*row)[1]);
    }
    return names;
}

TEST(CommandLine, HelpAndVersionGoToStandardOutput) {
    std::vector<std::vector<std::string>> calls{{"--help"}, {"--version"}};
    for (const std::string& verb : verbs()) {
        calls.push_back({verb, "--help"});
    }
    for (const std::vector<std::string>& call : calls) {
        const ProgramRun run = runKerf(call);
        EXPECT_EQ(run.exitCode, 0) << call[0];
        EXPECT_FALSE(run.out.empty()) << call[0];
        EXPECT_EQ(run.errors, "") << call[0];
    }
}

TEST(CommandLine, HelpOfCompareNamesItsLimits) {
    const std::string help = runKerf({"compare", "--help"}).out;
    EXPECT_NE(help.find("at most 0.1 % of the pixels"), std::string::npos) << help;
    EXPECT_NE(help.find("the worst place by 0.13"), std::string::npos) << help;
}

TEST(CommandLine, MasksOfCompareStandBeforeOrBehindThePictures) {
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"compare", "--mask", "0,0,2,2", "--mask", "1,1,2,2", "a.png",
                                   "b.png"},
          {"compare", "a.png", "b.png", "--mask", "0,0,2,2", "--mask", "1,1,2,2"}}) {
        expectMistake(runKerf(call), 3, "a.png");
    }
}

TEST(CommandLine, DocumentsEveryVerbThatIsForPeople) {
    const std::string docs = readBytes(KERF_SOURCE_DIR "/docs/cli.md");
    const std::vector<std::string> names = verbs();
    EXPECT_EQ(std::ranges::count(names, "replay"), 1);
    EXPECT_EQ(std::ranges::count(names, "import-worker"), 0);
    for (const std::string& verb : names) {
        EXPECT_NE(docs.find("| `kerf " + verb + " "), std::string::npos) << verb;
    }
}

TEST(CommandLine, WrongUsageIsOneSentenceAndExitCode2) {
    expectMistake(runKerf({"replay"}), 2, "SESSION");
    expectMistake(runKerf({"replay", "a.kerf.json"}), 2, "--out");
    expectMistake(runKerf({"replay", "a.kerf.json", "b.kerf.json", "--out", "x"}), 2,
                  "b.kerf.json");
    expectMistake(runKerf({"--no-such-option"}), 2, "--no-such-option");
    expectMistake(runKerf({"experimant"}), 2, "neither a verb nor a file");
    expectMistake(runKerf({"compare", "a.png"}), 2, "B");
    expectMistake(runKerf({"compare", "a.png", "b.png", "--threshold", "2"}), 2, "threshold");
    expectMistake(runKerf({"compare", "a.png", "b.png", "--threshold", "nan"}), 2, "threshold");
    expectMistake(runKerf({"compare", "a.png", "b.png", "--mask", "1,2,3"}), 2, "1,2,3");
    expectMistake(runKerf({"compare", "a.png", "b.png", "--tolerant", "--threshold", "0"}), 2,
                  "--threshold");
    expectMistake(runKerf({"a.obj", "inspect", "b.obj"}), 2, "verb comes first");
    expectMistake(runKerf({"a.obj", "experiment"}), 2, "verb comes first");
}

TEST(CommandLine, EmptyNamesAreWrongUsage) {
    expectMistake(runKerf({"replay", "", "--out", "x"}), 2, "SESSION: the name is empty");
    expectMistake(runKerf({"replay", "a.kerf.json", "--out", ""}), 2, "--out: the name is empty");
    expectMistake(runKerf({"inspect", ""}), 2, "MODEL: the name is empty");
}

TEST(CommandLine, NamesThatNoFileCanHaveAreMistakes) {
    const std::string longName(5000, 'a');
    expectMistake(runKerf({longName}), 2, "neither a verb nor a file");
    expectMistake(runKerf({"inspect", longName}), 3, "");
    expectMistake(runKerf({"inspect", longName + ".obj"}), 3, "");
    expectMistake(runKerf({"replay", longName, "--out", "x"}), 3, "");
    expectMistake(runKerf({"inspect", "two\nlines\x1b[31m.obj"}), 3, "two?lines?[31m.obj");
}

TEST(CommandLine, ReadsModelsUnderAnyNameOfTheProgram) {
    const test::TemporaryFolder folder;
    fs::copy_file(KERF_BINARY_DIR "/kerf", folder / "other");
    fs::copy_file(KERF_BINARY_DIR "/kerf-import", folder / "kerf-import");
    const std::string call = "'" + (folder / "other").string() + "' inspect sphere20 >'" +
                             (folder / "out").string() + "'";
    EXPECT_EQ(std::system(call.c_str()), 0);
    EXPECT_NE(readBytes(folder / "out").find("triangles  20"), std::string::npos);
}

TEST(CommandLine, SaysWhereTheLaboratoryWouldLie) {
    const test::TemporaryFolder folder;
    fs::copy_file(KERF_BINARY_DIR "/kerf", folder / "kerf");
    const std::string call = "'" + (folder / "kerf").string() + "' experiment --help 2>'" +
                             (folder / "errors").string() + "'";
    EXPECT_EQ(WEXITSTATUS(std::system(call.c_str())), 3);
    const std::string errors = readBytes(folder / "errors");
    EXPECT_NE(errors.find((folder / "kerf-lab").string() + ", which runs"), std::string::npos)
        << errors;
    EXPECT_NE(errors.find("scripts/build"), std::string::npos) << errors;
}

TEST(CommandLine, AResultThatCannotBeWrittenIsExitCode5) {
    const int status =
        std::system("'" KERF_BINARY_DIR "/kerf' inspect sphere20 >/dev/full 2>/dev/null");
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 5);
}

TEST(CommandLine, MissingInputsAreExitCode3) {
    expectMistake(runKerf({"replay", "none.kerf.json", "--out", "x"}), 3, "none.kerf.json");
    expectMistake(runKerf({"inspect", "none.obj"}), 3, "none.obj");
    expectMistake(runKerf({"compare", "none.png", "none.png"}), 3, "none.png");
}

TEST(CommandLine, WrongSessionsAreExitCode3AndWriteNothing) {
    const test::TemporaryFolder folder;
    const std::string head =
        R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"}, "steps": 5, )";
    writeText(folder / "key.kerf.json", head + R"("params": {"gravty": [0, 0, 0]}})");
    writeText(folder / "nan.kerf.json", head + "\n\"params\": {\"time_step\": NaN}}");
    const auto replay = [&](const std::string& name) {
        return runKerf({"replay", folder / name, "--out", folder / "out"});
    };
    expectMistake(replay("key.kerf.json"), 3,
                  "key.kerf.json: params.gravty: there is no parameter");
    expectMistake(replay("nan.kerf.json"), 3, "nan.kerf.json: line 2, column ");
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(CommandLine, AModelThatChangedIsRefused) {
    const test::TemporaryFolder folder;
    writeText(folder / "a.obj", openBox());
    writeText(folder / "a.kerf.json",
              R"({"format": "kerf-session", "version": 1, "steps": 5, "model": {"path": "a.obj",
                 "sha256": "0000000000000000000000000000000000000000000000000000000000000000"}})");
    expectMistake(runKerf({"replay", folder / "a.kerf.json", "--out", folder / "out"}), 3,
                  "a.obj: the model is not the one");
}

TEST(CommandLine, AnOpenMeshIsReportedAndRefused) {
    const test::TemporaryFolder folder;
    writeText(folder / "open.obj", openBox());
    const ProgramRun run = runKerf({"inspect", folder / "open.obj", "--json"});
    expectMistake(run, 3, "3 open edges");
    const auto report = Json::parse(run.out);
    EXPECT_EQ(report["closed"], false);
    EXPECT_EQ(report["cuttable"], false);
    EXPECT_EQ(report["open_edges"], 3);
}

TEST(CommandLine, InspectReportsABuiltinModel) {
    const ProgramRun run = runKerf({"inspect", "sphere80", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1);
    const auto report = Json::parse(run.out);
    EXPECT_EQ(report["vertices"], 42);
    EXPECT_EQ(report["triangles"], 80);
    EXPECT_EQ(report["pieces"], 1);
    EXPECT_EQ(report["cuttable"], true);
    EXPECT_NEAR(report["volume"].get<double>(), 0.4573, 1e-4);
    EXPECT_EQ(runKerf({"inspect", "sphere80"}).exitCode, 0);
}

TEST(CommandLine, InspectPrintsATableOfThePieces) {
    const test::TemporaryFolder folder;
    const TriangleSoup two =
        joined(boxSoup(Vec3(1, 1, 1), 1), boxSoup(Vec3(1, 1, 3), 1), Vec3(5, 0, 0));
    writeText(folder / "two.obj", objText(two));
    const ProgramRun run = runKerf({"inspect", folder / "two.obj", "--pieces"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 3);
    for (const char* part :
         {"\n1,12,1,1,0.25,6,0,", ",-0.5,-0.5,-0.5,0.5,0.5,0.5\n", "\n2,12,3,1,0.75,14,0,5,"}) {
        EXPECT_NE(run.out.find(part), std::string::npos) << run.out;
    }
    EXPECT_EQ(runKerf({"inspect", "sphere80", "--pieces", "--json"}).exitCode, 2);
    EXPECT_EQ(runKerf({"inspect", folder / "none.obj", "--pieces"}).exitCode, 3);
}

TEST(CommandLine, DocumentsEveryParameter) {
    const std::string docs = readBytes(KERF_SOURCE_DIR "/docs/session-format.md");
    for (const ParamInfo& info : paramTable()) {
        EXPECT_NE(docs.find("| `" + std::string(info.name) + "` |"), std::string::npos)
            << info.name;
    }
}

// A reset of the graphics driver without a window; with one: tests/app/window/editor_kill_test.cpp.

TEST(DriverReset, EndsAReplayWithASentence) {
    const test::TemporaryFolder folder;
    writeText(folder / "test.kerf.json", smallSession());
    writeText(folder / "lose", "");
    const ProgramRun run = runKerf({"replay", folder / "test.kerf.json", "--out", folder / "out"},
                                   {{"KERF_LOSE_CONTEXT", (folder / "lose").string()}});
    expectEnd(run, 4, "The graphics driver was reset");
    EXPECT_FALSE(fs::exists(folder / "out" / "summary.json"));
}

// What the verbs say of memory, and what they do where it does not do.

class Memory : public ::testing::Test {
  protected:
    void SetUp() override {
        writeText(folder / "fall.kerf.json",
                  R"({"format": "kerf-session", "version": 1,
                            "model": {"builtin": "sphere768"}, "params": {"floor": -0.6},
                            "steps": 2, "events": []})");
    }
    ProgramRun replay(const std::map<std::string, std::string>& environment) const {
        return runKerf({"replay", folder / "fall.kerf.json", "--out", folder / "out"}, environment);
    }

    test::TemporaryFolder folder;
};

TEST_F(Memory, InspectTellsWhatAModelNeeds) {
    const ProgramRun run = runKerf({"inspect", "banana"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_THAT(run.out, HasSubstr("memory     about"));
    const auto bytes = [](const std::string& model) {
        return Json::parse(
            runKerf({"inspect", model, "--json"}, {{"KERF_MEMORY_BYTES", "123000000"}})
                .out)["memory_bytes"];
    };
    const auto banana = bytes("banana");
    EXPECT_EQ(banana["free"], 123'000'000);
    EXPECT_GT(banana["needed"], bytes("sphere20")["needed"]);
    EXPECT_GT(banana["graphics"], bytes("sphere20")["graphics"]);
}

TEST_F(Memory, AReplayBeyondTheMeansIsRefusedBeforeItBegins) {
    for (const char* bytes : {"0", "1000000", "200000000"}) {
        const ProgramRun run = replay({{"KERF_MEMORY_BYTES", bytes}});
        EXPECT_EQ(run.exitCode, 5) << bytes << ": " << run.errors;
        EXPECT_THAT(run.errors, HasSubstr("cutting it needs about"));
        EXPECT_THAT(run.errors, HasSubstr("--remesh"));
        EXPECT_EQ(std::ranges::count(run.errors, '\n'), 1) << run.errors;
        EXPECT_FALSE(fs::exists(folder / "out" / "summary.json"));
    }
    EXPECT_EQ(replay({{"KERF_MEMORY_BYTES", "20000000000"}}).exitCode, 0);
}

/// Whatever the limit is, a run ends well or with one sentence, and never by a signal.
TEST_F(Memory, NoLimitOfTheProcessEndsInACrash) {
    for (const std::uint64_t megabytes : {400, 700, 1000, 1400, 2000, 4000}) {
        const ProgramRun run = runKerf(
            {"replay", folder / "fall.kerf.json", "--out", folder / std::to_string(megabytes)}, {},
            megabytes << 20);
        EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 5)
            << megabytes << " MB: " << run.exitCode << " " << run.errors;
        EXPECT_EQ(run.errors.empty(), run.exitCode == 0) << run.errors;
    }
}

// What `cmake --install` puts into a folder works from there, with its own shaders and assets.

class Installed : public testing::Test {
  protected:
    Installed() {
        said_ = outputOf("cmake --install '" KERF_BINARY_DIR "' --prefix '" + prefix() + "' 2>&1");
    }
    std::string prefix() const { return folder_ / "moved"; }
    std::string run(const std::string& arguments) const {
        return outputOf("cd '" + folder_.path().string() + "' && '" + prefix() + "/bin/kerf' " +
                        arguments + " 2>&1");
    }

    test::TemporaryFolder folder_;
    std::string said_;
};

TEST_F(Installed, TheProgramReadsWhatWasInstalledWithIt) {
    ASSERT_THAT(said_, Not(HasSubstr("failed")));
    const std::string replay =
        "replay moved/share/kerf/assets/sessions/sphere20.kerf.json --until 12 --out out";
    EXPECT_THAT(run(replay), HasSubstr("sphere20: 12 steps"));

    // What the source tree has is as it was: only the copies that lie there are changed.
    fs::copy_file(prefix() + "/share/kerf/assets/materials/gelatin.json",
                  prefix() + "/share/kerf/assets/materials/unobtainium.json");
    EXPECT_THAT(run("materials"), HasSubstr("unobtainium"));
    for (const auto& shader : fs::recursive_directory_iterator(prefix() + "/share/kerf/shaders")) {
        if (shader.path().extension() == ".comp") {
            writeText(shader.path(), "no shader");
        }
    }
    EXPECT_THAT(run(replay), HasSubstr("syntax error"));
}

TEST_F(Installed, ThePagesKnowAllVerbs) {
    const std::string page = outputOf("zcat '" + prefix() + "/share/man/man1/kerf.1.gz'");
    const std::string completion = readBytes(prefix() + "/share/bash-completion/completions/kerf");
    for (const char* const verb : {"replay", "experiment", "inspect", "compare", "test",
                                   "materials", "schema", "sweep", "reduce", "doctor", "score"}) {
        EXPECT_THAT(completion, HasSubstr(std::string(verb) + ") words='"));
        EXPECT_THAT(page, HasSubstr(std::string("kerf ") + verb + " "));
    }
    EXPECT_THAT(page, HasSubstr("\\-\\-movie FILE\n"));
    EXPECT_THAT(page, Not(HasSubstr("TEXT")));
    const auto completed = [&](const std::string& words, int at) {
        return outputOf("bash -c \"source '" + prefix() +
                        "/share/bash-completion/completions/kerf'; COMP_WORDS=(" + words +
                        "); COMP_CWORD=" + std::to_string(at) +
                        "; _kerf; echo \\${COMPREPLY[*]}\"");
    };
    EXPECT_EQ(completed("kerf ex", 1), "experiment\n");
    EXPECT_EQ(completed("kerf replay --mo", 2), "--movie\n");
    EXPECT_EQ(completed("kerf replay --meshes v", 3), "vtp\n");
    EXPECT_EQ(completed("kerf materials gel", 2), "gelatin\n");
    EXPECT_EQ(completed("kerf inspect --out", 2), "\n") << "that is no option of it";
}

TEST_F(Installed, TheDesktopFindsAllItsParts) {
    for (const char* const part :
         {"share/applications/kerf.desktop", "share/mime/packages/kerf.xml",
          "share/metainfo/kerf.metainfo.xml", "share/icons/hicolor/scalable/apps/kerf.svg",
          "share/doc/kerf/copyright", "share/kerf/assets/models/banana.obj",
          "share/kerf/assets/environments/studio-dark.hdr"}) {
        EXPECT_TRUE(fs::exists(fs::path(prefix()) / part)) << part;
    }
    EXPECT_FALSE(fs::exists(prefix() + "/share/kerf/assets/models/make_models.py"));
}

}  // namespace
}  // namespace kerf::app
