// The sessions of the repository, cut with each way to search for triangles.
#include <gtest/gtest.h>

#include "app/files/import/model_source.h"
#include "app/session/session.h"
#include "app/session/simulation_driver.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"

namespace kerf {
namespace {

/// Takes what a session says and keeps what its blade does.
struct Host {
    void perform(const Command& command, int) {
        EXPECT_EQ(simulation.execute(command), "");
        cuts = cuts || std::holds_alternative<MoveBlade>(command);
        lifted = lifted || std::holds_alternative<LiftBlade>(command);
    }
    template <class Event>
    void take(const Event&) {}

    Simulation& simulation;
    bool cuts = false;
    bool lifted = false;
};

struct CutRun {
    std::string stateHash;
    int pieces = 0;
    bool cut = false;
};

/// Up to the end of the first stroke. One iteration and no contact will do, for what the cutter
/// looks up.
CutRun cutOf(const app::Session& session, CutSearch search) {
    Params params = session.params;
    params.cutSearch = search;
    params.iterations = 1;
    params.contact = 0;
    Simulation simulation(app::loadSessionModel(session).mesh, params, session.boxes);
    const app::SessionSchedule schedule(session);
    app::SimulationDriver driver(simulation);
    Host host{simulation};
    while (!host.lifted && simulation.stepCount() < session.steps) {
        driver.applyActions(schedule, host);
        driver.step();
    }
    return {simulation.stateHash(), simulation.report().pieces, host.cuts};
}

class CutSearchSessions : public test::GlTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(CutSearchSessions, EndInTheSameStateHoweverTrianglesAreFound) {
    const app::Session session =
        app::readSession(std::filesystem::path(KERF_SOURCE_DIR) / "assets/sessions" /
                         (std::string(GetParam()) + ".kerf.json"));
    const CutRun tree = cutOf(session, CutSearch::tree);
    ASSERT_TRUE(tree.cut);
    EXPECT_EQ(tree.pieces, 2);
    EXPECT_EQ(cutOf(session, CutSearch::adjacency).stateHash, tree.stateHash);
    EXPECT_EQ(cutOf(session, CutSearch::all).stateHash, tree.stateHash);
}

// The others have no blade.
INSTANTIATE_TEST_SUITE_P(All, CutSearchSessions,
                         ::testing::Values("banana", "first-cut", "octopus", "open-cut", "sphere20",
                                           "sphere768", "sphere80"),
                         [](const auto& each) {
                             std::string name = each.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace kerf
