// A cut with the paper's solver, contact and course.
#include <gtest/gtest.h>

#include "app/files/import/model_source.h"
#include "app/session/session.h"
#include "app/session/simulation_driver.h"
#include "sim/mesh/piece_labels.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"

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
    app::Session session = app::readSession(std::filesystem::path(KERF_SOURCE_DIR) /
                                            "assets/sessions" / (std::string(name) + ".kerf.json"));
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

class PublishedCut : public test::GlTest {};

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

}  // namespace
}  // namespace kerf
