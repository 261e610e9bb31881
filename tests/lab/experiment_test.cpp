#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/session/paper_experiments.h"
#include "app/session/session.h"
#include "render/scene/image.h"
#include "tests/paths.h"
#include "tests/support/run_kerf.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using test::readBytes;
using test::runKerf;
using test::TemporaryFolder;

class PaperSessions : public ::testing::TestWithParam<app::PaperExperiment> {};

TEST_P(PaperSessions, HaveThePapersSettingsAndCourse) {
    const app::PaperExperiment& paper = GetParam();
    const app::Session session =
        app::readSession(std::filesystem::path(KERF_SOURCE_DIR) / "assets/sessions" /
                         (std::string(paper.name) + ".kerf.json"));
    EXPECT_EQ(session.model.builtin, paper.name);
    EXPECT_EQ(session.params.timeStep, paper.timeStep);
    EXPECT_EQ(session.params.iterations, paper.iterations);
    EXPECT_TRUE(session.params.floor.has_value());
    EXPECT_EQ(session.params.gravity, Vec3::Zero()) << "while the blade cuts";
    std::vector<const MoveBlade*> poses;
    const kerf::SetParam* gravity = nullptr;
    for (const app::SessionEvent& event : session.events) {
        if (const auto* pose = std::get_if<MoveBlade>(&event.action)) {
            EXPECT_EQ(gravity, nullptr);
            poses.push_back(pose);
        }
        if (const auto* set = std::get_if<kerf::SetParam>(&event.action)) {
            gravity = set;
        }
    }
    ASSERT_EQ(poses.size(), 2u);
    EXPECT_GT(poses[0]->blade.a.y(), poses[1]->blade.a.y()) << "it comes down";
    ASSERT_NE(gravity, nullptr);
    EXPECT_EQ(gravity->name, "gravity");
}

INSTANTIATE_TEST_SUITE_P(All, PaperSessions, ::testing::ValuesIn(app::paperExperiments()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(Experiment, LeavesWhatTheContractSays) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "out");
    test::writeText(folder / "out/report.md", "of an earlier run");
    const test::ProgramRun run =
        runKerf({"experiment", "sphere20", "--runs", "2", "--out", folder / "out", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    const auto printed = nlohmann::json::parse(run.out);
    const auto summary = nlohmann::json::parse(readBytes(folder / "out/sphere20/summary.json"));
    EXPECT_EQ(printed["experiments"]["sphere20"]["state_hash"], summary["state_hash"]);
    EXPECT_EQ(summary["pieces"].size(), 2u);
    EXPECT_EQ(render::readPng(folder / "out/sphere20/plots.png").width, 900);
    const std::string report = readBytes(folder / "out/report.md");
    EXPECT_NE(report.find("| Sphere 20 | 100.00 | "), std::string::npos) << report;
    EXPECT_NE(report.find("99.6"), std::string::npos) << "the paper's mean volume";
    for (const char* figure : {"figure-5a", "figure-7a", "figure-9", "figure-10"}) {
        const std::string file = std::string("figures/") + figure + ".png";
        EXPECT_NE(report.find("](" + file + ")"), std::string::npos) << file;
        EXPECT_GT(render::readPng(folder / "out" / file).width, 900) << file;
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "out/sphere20/runs/2/metrics.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out/sphere20/runs/3"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/sphere20/search/adjacency/metrics.csv"));
    EXPECT_NE(report.find("| Sphere 20 | adjacency | "), std::string::npos);
    EXPECT_EQ(report.find("Octopus"), std::string::npos) << "was not run";
}

TEST(Experiment, RunsAsPublished) {
    const TemporaryFolder folder;
    const test::ProgramRun run = runKerf({"experiment", "sphere20", "--published", "--runs", "1",
                                          "--out", folder / "out", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    const auto summary = nlohmann::json::parse(readBytes(folder / "out/sphere20/summary.json"));
    EXPECT_EQ(summary["pieces"].size(), 2u);
    EXPECT_FALSE(summary["closed_every_step"]) << "open while the blade is in it";
    EXPECT_LT(summary["volume_ratio"]["min"], 0.999) << "the paper's solver loses volume";
    EXPECT_GT(summary["volume_ratio"]["min"], 0.95);
    EXPECT_TRUE(summary["failures"].empty());
    const std::string report = readBytes(folder / "out/report.md");
    EXPECT_NE(report.find("(`solver` pbd, `paper_contact`, `open_cut`)"), std::string::npos);
    EXPECT_NE(report.find("lips apart"), std::string::npos) << "what the hollow picture shows";
    EXPECT_TRUE(std::filesystem::exists(folder / "out/sphere20/hollow/hollow.png"));
}

TEST(Experiment, HelpIsThatOfTheLaboratory) {
    const test::ProgramRun run = runKerf({"experiment", "--help"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_NE(run.out.find("Usage: kerf experiment [OPTIONS] NAME\n"), std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("--published"), std::string::npos) << run.out;
    EXPECT_EQ(run.errors, "");
}

TEST(Experiment, WrongUsageIsOneSentenceAndExitCode2) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
        {{"--out", "x"}, "NAME"},
        {{"all"}, "--out"},
        {{"bar", "--published", "--out", "x"}, "takes neither --published nor --runs"},
        {{"bar", "--runs", "2", "--out", "x"}, "takes neither --published nor --runs"},
        {{"fem", "--runs", "2", "--out", "x"}, "'fem' is none of the paper's experiments"},
        {{"sphere20", "--whole", "--out", "x"}, "--whole is for 'bar' alone"},
        {{"all", "--runs", "0", "--out", "x"}, "--runs"},
        {{"cube", "--out", "x"}, "there is no experiment 'cube'; there are sphere20, "}};
    for (auto [words, told] : mistakes) {
        words.insert(words.begin(), "experiment");
        const test::ProgramRun run = runKerf(words);
        EXPECT_EQ(run.exitCode, 2) << run.errors;
        EXPECT_EQ(std::ranges::count(run.errors, '\n'), 1) << run.errors;
        EXPECT_NE(run.errors.find(told), std::string::npos) << run.errors;
    }
}

TEST(Experiment, WithoutOpenGlNothingIsWritten) {
    const TemporaryFolder folder;
    const test::ProgramRun run =
        runKerf({"experiment", "all", "--out", folder / "out"}, {{"KERF_FORCE_NO_GL", "1"}});
    EXPECT_EQ(run.exitCode, 4) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace kerf
