#include "bench/lab/hollow_session.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/files/import/model_source.h"
#include "app/session/paper_experiments.h"
#include "tests/paths.h"

namespace kerf::app {
namespace {

Session sessionOf(const PaperExperiment& paper) {
    return readSession(std::filesystem::path(KERF_SOURCE_DIR) / "assets/sessions" /
                       (std::string(paper.name) + ".kerf.json"));
}

template <class Action>
std::vector<Action> actionsOf(const Session& session) {
    std::vector<Action> out;
    for (const SessionEvent& event : session.events) {
        if (const auto* action = std::get_if<Action>(&event.action)) {
            out.push_back(*action);
        }
    }
    return out;
}

class HollowSession : public ::testing::TestWithParam<PaperExperiment> {};

TEST_P(HollowSession, DrawsBothLipsAwayFromTheBlade) {
    const Session session = sessionOf(GetParam());
    const std::optional<Session> hollow = hollowSession(session, loadSessionModel(session).mesh);
    ASSERT_TRUE(hollow.has_value());
    EXPECT_LT(hollow->steps, session.steps);
    const auto blades = actionsOf<MoveBlade>(*hollow);
    const auto grabs = actionsOf<Grab>(*hollow);
    const auto drags = actionsOf<Drag>(*hollow);
    ASSERT_EQ(blades.size(), 2u);
    ASSERT_EQ(grabs.size(), 2u);
    ASSERT_EQ(drags.size(), 2u);
    const Blade& from = blades[0].blade;
    const Vec3 across = (from.b - from.a)
                            .cross(blades[1].blade.a + blades[1].blade.b - from.a - from.b)
                            .normalized();
    for (int hand = 0; hand < 2; ++hand) {
        const double beside = across.dot(grabs[hand].at - from.a);
        EXPECT_GT(std::abs(beside), 0.99 * grabs[hand].radius) << "it holds one side alone";
        EXPECT_GT(beside * across.dot(drags[hand].to - grabs[hand].at), 0) << "it draws outwards";
    }
    EXPECT_LT(across.dot(grabs[0].at - from.a) * across.dot(grabs[1].at - from.a), 0);
}

INSTANTIATE_TEST_SUITE_P(All, HollowSession, ::testing::ValuesIn(paperExperiments()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(HollowSessions, NeedAPictureOfTheCut) {
    Session session = sessionOf(paperExperiments().front());
    const SurfaceMesh mesh = loadSessionModel(session).mesh;
    std::erase_if(session.events, [](const SessionEvent& event) {
        return std::holds_alternative<ScreenshotEvent>(event.action);
    });
    EXPECT_FALSE(hollowSession(session, mesh).has_value());
    session.events.clear();
    EXPECT_FALSE(hollowSession(session, mesh).has_value());
}

}  // namespace
}  // namespace kerf::app
