// kerf score.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/files/io/file_io.h"
#include "app/practice/score.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using nlohmann::ordered_json;
using test::ProgramRun;
using test::runKerf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

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
        std::filesystem::create_directories(folder_.path() / person / "run");
        test::writeText(folder_.path() / person / "run" / "summary.json",
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
    test::writeText(pathOf("bad.json"), "{");
    refuse(pathOf("bad.json"), "bad.json: ");
    test::writeText(pathOf("plain.json"), R"({"steps": 3})");
    refuse(pathOf("plain.json"),
           "plain.json: there is no score; give a session (*.kerf.json) with a task");
    test::writeText(pathOf("ann/bad.kerf.json"), "{");
    refuse(pathOf("ann"), pathOf("ann/bad.kerf.json"));
    std::filesystem::create_directories(pathOf("empty"));
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
    EXPECT_FALSE(std::filesystem::exists(both));
}

}  // namespace
}  // namespace kerf
