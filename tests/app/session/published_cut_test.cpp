// A cut with the paper's solver, contact and course.
#include "sim/mesh/piece_labels.h"

namespace kerf {
namespace {

constexpr int kFallen = 350;  // steps, of which the fall takes about 80

struct PublishedHost {
    void perform(const Command& command, int) { EXPECT_EQ(simulation.execute(command), ""); }
    template <class Event>
    void take(const Event&) {}

    Simulation& simulation;
};

app::Session publishedSession(const char* name) {
    app::Session session = app::readSession(fs::path(KERF_SOURCE_DIR) / "assets/sessions" /
                                            (std::string(name) + ".kerf.json"));
    session.params.solver = SolverMode::pbd;
    session.params.paperContact = 1;
    session.params.openCut = 1;
    return session;
}

/// Of the volumes of the two pieces, at rest or as they are [m].
double distanceOfHalves(const SurfaceMesh& mesh, bool atRest) {
    const std::vector<int> pieceOf = PieceLabels(mesh).ofVertex();
    const auto at = [&](int v) { return atRest ? mesh.restPosition(v) : mesh.position(v); };
    std::array<Vec3, 2> moments{Vec3::Zero(), Vec3::Zero()};
    std::array<double, 2> volumes{};
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t)) {
            const auto [a, b, c] = mesh.triangle(t);
            const double volume = at(a).dot(at(b).cross(at(c)));
            moments.at(pieceOf[a]) += volume / 4 * (at(a) + at(b) + at(c));
            volumes.at(pieceOf[a]) += volume;
        }
    }
    return (moments[0] / volumes[0] - moments[1] / volumes[1]).norm();
}

class PublishedCut : public GlTest {};

TEST_F(PublishedCut, ItsHalvesComeApart) {
    const app::Session session = publishedSession("sphere768");
    Simulation simulation(app::loadSessionModel(session).mesh, session.params, session.boxes);
    const app::SessionSchedule schedule(session);
    app::SimulationDriver driver(simulation);
    PublishedHost host{simulation};
    while (simulation.stepCount() < kFallen) {
        driver.applyActions(schedule, host);
        driver.step();
    }
    ASSERT_EQ(simulation.report().pieces, 2);
    const double atRest = distanceOfHalves(simulation.mesh(), true);
    EXPECT_NEAR(atRest, 0.37, 0.02);
    EXPECT_GT(distanceOfHalves(simulation.mesh(), false), 1.5 * atRest);
    EXPECT_EQ(simulation.report().contacts, 0);
}

// The sessions of the repository, cut with each way to search for triangles.

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

class CutSearchSessions : public GlTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(CutSearchSessions, EndInTheSameStateHoweverTrianglesAreFound) {
    const app::Session session = app::readSession(fs::path(KERF_SOURCE_DIR) / "assets/sessions" /
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
