#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>

#include "sim/base/params.h"
#include "tests/paths.h"
#include "tests/support/run_kerf.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using test::ProgramRun;
using test::readBytes;
using test::runKerf;
using test::TemporaryFolder;
using test::writeText;

/// The exit code is `code` and standard error one sentence that contains `words`.
void expectMistake(const ProgramRun& run, int code, const std::string& words) {
    EXPECT_EQ(run.exitCode, code) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_NE(run.errors.find(words), std::string::npos) << run.errors;
}

/// A box that lacks one triangle, as the text of an OBJ file.
std::string openBox() {
    TriangleSoup soup = test::boxSoup();
    soup.triangles.pop_back();
    return test::objText(soup);
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
    const TemporaryFolder folder;
    std::filesystem::copy_file(KERF_BINARY_DIR "/kerf", folder / "other");
    const std::string call = "'" + (folder / "other").string() + "' inspect sphere20 >'" +
                             (folder / "out").string() + "'";
    EXPECT_EQ(std::system(call.c_str()), 0);
    EXPECT_NE(readBytes(folder / "out").find("triangles  20"), std::string::npos);
}

TEST(CommandLine, SaysWhereTheLaboratoryWouldLie) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(KERF_BINARY_DIR "/kerf", folder / "kerf");
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
    const TemporaryFolder folder;
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
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(CommandLine, AModelThatChangedIsRefused) {
    const TemporaryFolder folder;
    writeText(folder / "a.obj", openBox());
    writeText(folder / "a.kerf.json",
              R"({"format": "kerf-session", "version": 1, "steps": 5, "model": {"path": "a.obj",
                 "sha256": "0000000000000000000000000000000000000000000000000000000000000000"}})");
    expectMistake(runKerf({"replay", folder / "a.kerf.json", "--out", folder / "out"}), 3,
                  "a.obj: the model is not the one");
}

TEST(CommandLine, TextRenamedToObjIsRefused) {
    const TemporaryFolder folder;
    writeText(folder / "notes.obj", "Dear diary, today I did not model anything.\n");
    expectMistake(runKerf({"inspect", folder / "notes.obj"}), 3, "notes.obj");
}

TEST(CommandLine, AnOpenMeshIsReportedAndRefused) {
    const TemporaryFolder folder;
    writeText(folder / "open.obj", openBox());
    const ProgramRun run = runKerf({"inspect", folder / "open.obj", "--json"});
    expectMistake(run, 3, "3 open edges");
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["closed"], false);
    EXPECT_EQ(report["cuttable"], false);
    EXPECT_EQ(report["open_edges"], 3);
}

TEST(CommandLine, InspectReportsABuiltinModel) {
    const ProgramRun run = runKerf({"inspect", "sphere80", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1);
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(report["vertices"], 42);
    EXPECT_EQ(report["triangles"], 80);
    EXPECT_EQ(report["pieces"], 1);
    EXPECT_EQ(report["cuttable"], true);
    EXPECT_NEAR(report["volume"].get<double>(), 0.4573, 1e-4);
    EXPECT_EQ(runKerf({"inspect", "sphere80"}).exitCode, 0);
}

TEST(CommandLine, InspectPrintsATableOfThePieces) {
    const test::TemporaryFolder folder;
    const TriangleSoup two = test::joined(test::boxSoup(Vec3(1, 1, 1), 1),
                                          test::boxSoup(Vec3(1, 1, 3), 1), Vec3(5, 0, 0));
    test::writeText(folder / "two.obj", test::objText(two));
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

}  // namespace
}  // namespace kerf
