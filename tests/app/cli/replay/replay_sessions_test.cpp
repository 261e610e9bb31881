#include "app/cli/replay/replay.h"
#include "app/files/import/model_source.h"
#include "app/session/simulation_driver.h"
#include "sim/run/simulation.h"
#include "tests/paths.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/nightly.h"
#include "tests/support/shape_error.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

std::filesystem::path sessionFile(const std::string& name) {
    return std::filesystem::path(KERF_SOURCE_DIR) / "assets/sessions" / (name + ".kerf.json");
}

TEST(ShippedSessions, AreReadWithoutWarnings) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(KERF_SOURCE_DIR) / "assets/sessions")) {
        EXPECT_EQ(readSession(entry.path()).warnings, std::vector<std::string>{});
        names.insert(entry.path().filename().stem().stem().string());
    }
    EXPECT_EQ(names,
              (std::set<std::string>{"banana", "boxes", "drop-in", "first-cut", "material",
                                     "octopus", "open-cut", "sphere20", "sphere768", "sphere80"}));
}

TEST(ShippedSessions, DropInIsASphereInTheMiddleOfTheDefaultView) {
    const Session session = readSession(sessionFile("drop-in"));
    EXPECT_EQ(session.params.gravity, Vec3::Zero());
    EXPECT_FALSE(session.view.has_value());
    const Bounds bounds = meshBounds(loadSessionModel(session).mesh);
    const render::Camera camera = sessionCamera(session, bounds);
    EXPECT_LT((camera.target - bounds.center()).norm(), 1e-9);
}

class FoundSessions : public test::GlTest {
  protected:
    static ReplayResult replay(const std::string& name) {
        const Session session = readSession(std::filesystem::path(KERF_SOURCE_DIR) /
                                            ("tests/sessions/" + name + ".kerf.json"));
        const test::TemporaryFolder out;
        return replaySession(session, loadSessionModel(session), out.path(), {});
    }
};

// Hands pull the body over both ends of the blade, and a piece parts in which nothing of its front
// is.
TEST_F(FoundSessions, AFrontThatIsAllInOtherPieces) {
    const ReplayResult result = replay("front-in-other-pieces");
    EXPECT_EQ(result.summary.failures, std::vector<std::string>{});
    EXPECT_TRUE(result.summary.statistics.closedEveryStep);
}

// Where a push moved what other threads were looking at, one replay in five with two threads was
// another.
TEST_F(FoundSessions, APushingBladeReplaysToTheSameBits) {
    const auto hash = [] { return replay("pushing-blade").summary.stateHash; };
    const auto first = hash();
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(hash(), first);
    }
}

/// The bars that a body must clear while it is cut and falls.
struct Bar {
    const char* session;
    int steps;               ///< of the session's, enough for the impact and the rebound
    double peakDeformation;  ///< least RMS at impact, share of the diagonal
    bool byNight = false;    ///< the others find the same, and RegressionSessions cut it by day
};

class ShippedModels : public test::GlTest, public ::testing::WithParamInterface<Bar> {};

/// Largest RMS deformation of a piece after rigid alignment [m].
double largestDeformation(Simulation& simulation) {
    const SurfaceMesh& mesh = simulation.mesh();
    const PieceMap& pieces = simulation.pieces();
    double largest = 0;
    for (int piece = 0; piece < static_cast<int>(pieces.pieces.size()); ++piece) {
        std::vector<int> vertices;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (pieces.ofVertex[v] == piece) vertices.push_back(v);
        }
        largest = std::max(largest,
                           test::rmsShapeError(mesh.restPositions(), mesh.positions(), vertices));
    }
    return largest;
}

/// Runs the commands of a session, without its pictures.
class SessionRun {
  public:
    explicit SessionRun(const Session& session)
        : schedule_(session), simulation_(loadSessionModel(session).mesh, session.params) {}

    const StepReport& step() {
        driver_.applyActions(schedule_, *this);
        return driver_.step();
    }
    Simulation& simulation() { return simulation_; }

    void perform(const Command& command, int) { EXPECT_EQ(simulation_.execute(command), ""); }
    template <class Event>
    void take(const Event&) {}

  private:
    SessionSchedule schedule_;
    Simulation simulation_;
    SimulationDriver driver_{simulation_};
};

TEST_P(ShippedModels, CutInTwoKeepTheirVolumeStayClosedAndAreSoft) {
    if (GetParam().byNight) {
        KERF_BY_NIGHT();
    }
    const Session session = readSession(sessionFile(GetParam().session));
    SessionRun run(session);
    const double diagonal = meshBounds(run.simulation().mesh()).diagonal();
    double volumeSum = 0;
    double peakDeformation = 0;
    for (int step = 0; step < GetParam().steps; ++step) {
        const StepReport& report = run.step();
        ASSERT_TRUE(report.closed) << "step " << step;
        ASSERT_TRUE(std::isfinite(report.volume)) << "step " << step;
        volumeSum += report.volumeRatio;
        if (step % 4 == 0) {
            peakDeformation = std::max(peakDeformation, largestDeformation(run.simulation()));
        }
    }
    const StepReport& end = run.simulation().report();
    EXPECT_EQ(end.pieces, 2);
    EXPECT_GE(volumeSum / GetParam().steps, 0.995);
    EXPECT_GE(end.volumeRatio, 0.999);
    EXPECT_GE(peakDeformation / diagonal, GetParam().peakDeformation);
    EXPECT_EQ(run.simulation().takeMessages(), std::vector<std::string>{});
    RecordProperty("peak_deformation_percent", std::to_string(100 * peakDeformation / diagonal));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedModels,
                         ::testing::Values(Bar{"sphere20", 600, 0.03}, Bar{"sphere80", 600, 0.03},
                                           Bar{"sphere768", 600, 0.03},
                                           Bar{"banana", 500, 0.01, true},
                                           Bar{"octopus", 320, 0.01, true}),
                         [](const auto& each) { return std::string(each.param.session); });

}  // namespace
}  // namespace kerf::app
