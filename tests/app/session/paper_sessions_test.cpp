// The sessions of the paper's experiments are those that it tells of.
#include <gtest/gtest.h>

#include "app/session/paper_experiments.h"
#include "app/session/session.h"
#include "tests/paths.h"

namespace kerf::app {
namespace {

class PaperSessions : public ::testing::TestWithParam<PaperExperiment> {};

TEST_P(PaperSessions, HaveThePapersSettingsAndCourse) {
    const PaperExperiment& paper = GetParam();
    const Session session = readSession(std::filesystem::path(KERF_SOURCE_DIR) / "assets/sessions" /
                                        (std::string(paper.name) + ".kerf.json"));
    EXPECT_EQ(session.model.builtin, paper.name);
    EXPECT_EQ(session.params.timeStep, paper.timeStep);
    EXPECT_EQ(session.params.iterations, kAutoIterations) << "those of the paper are sweeps";
    EXPECT_TRUE(session.params.floor.has_value());
    EXPECT_EQ(session.params.gravity, Vec3::Zero()) << "while the blade cuts";
    std::vector<const MoveBlade*> poses;
    const kerf::SetParam* gravity = nullptr;
    for (const SessionEvent& event : session.events) {
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

INSTANTIATE_TEST_SUITE_P(All, PaperSessions, ::testing::ValuesIn(paperExperiments()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace kerf::app
