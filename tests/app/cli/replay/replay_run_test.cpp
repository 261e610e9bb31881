#include "tests/support/shape_error.h"

namespace kerf::app {
namespace {

ProgramRun replay(const test::TemporaryFolder& folder, const std::string& session,
                  const std::string& out,
                  const std::map<std::string, std::string>& environment = {}) {
    writeText(folder / "test.kerf.json", session);
    return runKerf({"replay", folder / "test.kerf.json", "--out", folder / out, "--json"},
                   environment);
}

std::set<std::string> filesBelow(const fs::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.insert(entry.path().lexically_relative(folder).generic_string());
        }
    }
    return files;
}

/// metrics.csv without the columns of wall-clock time: milliseconds, and the real-time factor.
std::string withoutTimes(const std::string& metrics) {
    std::istringstream lines(metrics);
    std::vector<bool> kept;
    std::string text;
    for (std::string line; std::getline(lines, line); text += "\n") {
        std::istringstream cells(line);
        std::size_t column = 0;
        for (std::string cell; std::getline(cells, cell, ','); ++column) {
            if (column == kept.size()) {  // the header
                kept.push_back(!cell.ends_with("_ms") && cell != "real_time_factor");
            }
            text += kept[column] ? cell + "," : "";
        }
    }
    return text;
}

TEST(Replay, WritesWhatTheContractSaysAndNothingElse) {
    const test::TemporaryFolder folder;
    const ProgramRun run = replay(folder, smallSession(), "out");
    ASSERT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(filesBelow(folder / "out"),
              (std::set<std::string>{"end.mtl", "end.obj", "end.png", "final.ply", "metrics.csv",
                                     "pictures/half.png", "summary.json"}));
    EXPECT_EQ(filesBelow(folder.path()).size(), 8u) << "the session, and nothing beside DIR";
    const auto printed = Json::parse(run.out);
    const auto summary = Json::parse(readBytes(folder / "out/summary.json"));
    EXPECT_EQ(printed["state_hash"], summary["state_hash"]);
    EXPECT_EQ(summary["steps"], 40);
    EXPECT_EQ(summary["before"]["triangles"], 80);
    EXPECT_EQ(summary["pieces"].size(), 2u);
    EXPECT_TRUE(summary["closed_every_step"]);
    const std::string metrics = readBytes(folder / "out/metrics.csv");
    EXPECT_EQ(std::count(metrics.begin(), metrics.end(), '\n'), 41);
}

TEST(Replay, SameBytesWhateverTheNumberOfThreads) {
    const test::TemporaryFolder folder;
    for (const char* threads : {"0", "1", "2"}) {
        const ProgramRun run =
            replay(folder, smallSession(), threads, {{"LP_NUM_THREADS", threads}});
        ASSERT_EQ(run.exitCode, 0) << run.errors;
    }
    const auto hash = [&](const std::string& out) {
        return Json::parse(readBytes(folder / (out + "/summary.json")))["state_hash"];
    };
    for (const std::string other : {"1", "2"}) {
        EXPECT_EQ(hash(other), hash("0"));
        for (const char* file : {"/final.ply", "/end.obj", "/end.png", "/pictures/half.png"}) {
            const std::string bytes = readBytes(folder / (other + file));
            EXPECT_FALSE(bytes.empty()) << file;
            EXPECT_EQ(bytes == readBytes(folder / ("0" + std::string(file))), true)
                << file << " with " << other << " threads";
        }
        EXPECT_EQ(withoutTimes(readBytes(folder / (other + "/metrics.csv"))),
                  withoutTimes(readBytes(folder / "0/metrics.csv")));
    }
}

TEST(Replay, DivergenceIsNamedWithItsStepAndTheResultsStay) {
    const test::TemporaryFolder folder;
    const ProgramRun run = replay(
        folder, smallSession(R"(, {"step": 5, "type": "check", "hash": "0123456789abcdef"})"),
        "out");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.errors.find("Step 5: the state hash is "), std::string::npos) << run.errors;
    const auto summary = Json::parse(readBytes(folder / "out/summary.json"));
    EXPECT_EQ(summary["failures"].size(), 1u);
}

TEST(Replay, WrongNumberOfPiecesFailsTheCheck) {
    const test::TemporaryFolder folder;
    const ProgramRun run =
        replay(folder, smallSession(R"(, {"step": 0, "type": "check", "pieces": 3})"), "out");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.errors.find("Step 0: the model is in 1 piece where the session expects 3."),
              std::string::npos)
        << run.errors;
}

TEST(Replay, AnAbortedRunLeavesNoFinishedResults) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "out");
    writeText(folder / "out/summary.json", "of an earlier run");
    // By step 9 there is a piece's file where this export needs a folder.
    const ProgramRun run = replay(
        folder, smallSession(R"(, {"step": 8, "type": "export", "file": "e.ply", "per_piece": true},
                  {"step": 9, "type": "export", "file": "e-1.ply/x.ply"})"),
        "out");
    EXPECT_EQ(run.exitCode, 5) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(filesBelow(folder / "out"), (std::set<std::string>{"e-1.ply", "pictures/half.png"}));
}

TEST(Replay, LinksDoNotLeadOutOfTheFolder) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "out");
    fs::create_directories(folder / "elsewhere");
    fs::create_directory_symlink(folder / "elsewhere", folder / "out/pictures");
    const ProgramRun run = replay(folder, smallSession(), "out");
    EXPECT_EQ(run.exitCode, 5) << run.errors;
    EXPECT_TRUE(fs::is_empty(folder / "elsewhere"));
}

TEST(Replay, LinksToFilesDoNotLeadOutOfTheFolder) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "out");
    for (const char* name : {"metrics.csv", "end.png", "end.mtl", "final.ply", "summary.json"}) {
        writeText(folder / ("of-somebody-" + std::string(name)), "mine");
        fs::create_symlink(folder / ("of-somebody-" + std::string(name)),
                           folder / ("out/" + std::string(name)));
        const ProgramRun run = replay(folder, smallSession(), "out");
        EXPECT_EQ(readBytes(folder / ("of-somebody-" + std::string(name))), "mine") << run.errors;
        fs::remove_all(folder / "out");
        fs::create_directories(folder / "out");
    }
}

TEST(Replay, ModelsAreReadFromBesideAboveAndAbsolutePaths) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "sessions");
    fs::create_directories(folder / "models");
    const fs::path model = folder / "models/box.obj";
    writeText(model, objText(boxSoup()));
    for (const std::string& path : {std::string("../models/box.obj"), model.string()}) {
        writeText(folder / "sessions/a.kerf.json",
                  R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"path": ")" +
                      path + R"("}})");
        const ProgramRun run =
            runKerf({"replay", folder / "sessions/a.kerf.json", "--out", folder / "out"});
        EXPECT_EQ(run.exitCode, 0) << run.errors;
    }
}

TEST(Replay, ModelsThatAreNoFilesAreNamed) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", folder / "zero.obj");
    fs::create_directory(folder / "folder.obj");
    fs::create_symlink("loop.obj", folder / "loop.obj");
    for (const std::string& name :
         {std::string("pipe.obj"), std::string("zero.obj"), std::string("folder.obj"),
          std::string("loop.obj"), std::string("~/a.obj"), std::string(300, 'a') + ".obj",
          std::string(5000, 'a') + ".obj"}) {
        const ProgramRun run =
            replay(folder,
                   R"({"format": "kerf-session", "version": 1, "steps": 1, "model": {"path": ")" +
                       name + R"("}})",
                   "out");
        EXPECT_EQ(run.exitCode, 3) << name << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_FALSE(fs::exists(folder / "out")) << name;
    }
}

TEST(Replay, AnUndoBetweenTwoKeysEndsTheStrokeAsALiftDoes) {
    const test::TemporaryFolder folder;
    // The key at step 13 places the blade anew below the body.
    const std::string first = R"({"step": 0, "type": "set", "name": "friction", "value": 1}, )";
    const std::string keys =
        R"({"step": 1, "type": "blade", "a": [-0.8, 0.62, 0.02], "b": [0.8, 0.58, 0.05]},
           {"step": 13, "type": "blade", "a": [-0.8, -0.68, 0.02], "b": [0.8, -0.72, 0.05]})";
    for (const char* end : {"undo", "lift"}) {
        const std::string events =
            first + keys + R"(, {"step": 2, "type": ")" + std::string(end) + R"("})";
        const ProgramRun run = replay(folder, sessionThatDoes(events, 20), end);
        ASSERT_EQ(run.exitCode, 0) << run.errors;
        const auto summary = Json::parse(run.out);
        EXPECT_EQ(summary["after"]["triangles"], 20) << end;
    }
    const ProgramRun whole = replay(folder, sessionThatDoes(first + keys, 20), "whole");
    EXPECT_EQ(Json::parse(whole.out)["pieces"].size(), 2u) << "without one it cuts";
}

TEST(Replay, WhatCannotHappenIsNamedAsItStandsInTheFileAndNothingIsWritten) {
    const test::TemporaryFolder folder;
    const std::string other = R"({"step": 3, "type": "lift"}, )";
    const std::vector<std::pair<std::string, std::string>> mistakes{
        {R"({"step": 1, "type": "undo"})", "events[1] at step 1: There is nothing to undo."},
        {R"({"step": 0, "type": "redo"})", "events[1] at step 0: There is nothing to redo."},
        {R"({"step": 2, "type": "remove_box", "box": 0})", "events[1] at step 2: There is no box"},
        {R"({"step": 1, "type": "grab", "at": [9, 9, 9], "radius": 0.1})",
         "events[1] at step 1: No free vertex"},
        {R"({"step": 1, "type": "pin", "center": [9, 9, 9], "radius": 0.1})",
         "events[1] at step 1: No free vertex"},
        // A blade that turns around goes through a point.
        {R"({"step": 4, "type": "blade", "a": [8, 0, 0], "b": [9, 0, 0]},
            {"step": 0, "type": "blade", "a": [9, 0, 0], "b": [8, 0, 0]})",
         ""},
    };
    for (const auto& [event, sentence] : mistakes) {
        const bool turns = sentence.empty();
        const ProgramRun run =
            replay(folder, sessionThatDoes((turns ? "" : other) + event), "new/out");
        EXPECT_EQ(run.exitCode, 3) << event;
        const std::string expected =
            "kerf: test.kerf.json: " +
            (turns ? "events[0] at step 2: The two ends of the blade" : sentence);
        EXPECT_EQ(run.errors.substr(0, expected.size()), expected);
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_FALSE(fs::exists(folder / "new")) << event;
    }
}

TEST(Replay, ARefusedEventLeavesFoldersThatWereThereAndPicturesOfBefore) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "out");
    const std::string undo = R"({"step": 2, "type": "undo"})";
    EXPECT_EQ(replay(folder, sessionThatDoes(undo), "out").exitCode, 3);
    EXPECT_TRUE(fs::is_empty(folder / "out"));
    const std::string picture =
        R"({"step": 1, "type": "screenshot", "file": "a/b.png", "width": 8, "height": 8}, )";
    EXPECT_EQ(replay(folder, sessionThatDoes(picture + undo), "out").exitCode, 3);
    EXPECT_EQ(filesBelow(folder / "out"), (std::set<std::string>{"a/b.png"}));
}

TEST(Replay, ASessionOfBeforeSaysOnceThatItsSolverIsReplaced) {
    const test::TemporaryFolder folder;
    const std::string former =
        R"({"step": 0, "type": "set", "name": "solver", "value": "small_steps"})";
    const ProgramRun run = replay(folder, sessionThatDoes(former), "out");
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.errors,
              "warning: test.kerf.json: events[0].value: \"small_steps\" is no longer there, "
              "\"implicit\" takes its place.\n");
    const ProgramRun present = replay(folder, sessionThatDoes(""), "present");
    EXPECT_EQ(present.errors, "");
    EXPECT_EQ(Json::parse(run.out)["state_hash"], Json::parse(present.out)["state_hash"]);
}

TEST(Replay, ABodyThatTurnsInsideOutIsARemarkAndNoFailure) {
    const test::TemporaryFolder folder;
    // Two hands draw the top and the bottom through each other.
    const std::string session = R"({"format": "kerf-session", "version": 1, "steps": 16,
        "model": {"builtin": "sphere20"},
        "params": {"gravity": [0, 0, 0], "floor": null, "ispc_stiffness": 0, "iterations": 2,
                   "youngs_modulus": 1000, "contact": 0},
        "events": [{"step": 0, "type": "grab", "hand": 0, "at": [0, 0.45, 0], "radius": 0.4},
                   {"step": 0, "type": "grab", "hand": 1, "at": [0, -0.45, 0], "radius": 0.4},
                   {"step": 15, "type": "drag", "hand": 0, "to": [0, -0.7, 0]},
                   {"step": 15, "type": "drag", "hand": 1, "to": [0, 0.7, 0]}]})";
    const ProgramRun run = replay(folder, session, "out");
    EXPECT_EQ(run.exitCode, 0);
    const auto summary = Json::parse(readBytes(folder / "out/summary.json"));
    EXPECT_LT(summary["volume_ratio"]["min"], 0);
    ASSERT_EQ(summary["remarks"].size(), 2u);
    const std::string remark = summary["remarks"][0];
    EXPECT_NE(remark.find(": the body turned inside out, with -"), std::string::npos) << remark;
    const std::string crossings = summary["remarks"][1];
    EXPECT_NE(crossings.find("of the skin pass through each other"), std::string::npos)
        << crossings;
    EXPECT_NE(run.errors.find("test.kerf.json: " + remark), std::string::npos) << run.errors;
}

TEST(Replay, WithoutOpenGlNothingIsWritten) {
    const test::TemporaryFolder folder;
    const ProgramRun run = replay(folder, smallSession(), "out", {{"KERF_FORCE_NO_GL", "1"}});
    EXPECT_EQ(run.exitCode, 4) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_FALSE(fs::exists(folder / "out"));
}

fs::path sessionFile(const std::string& name) {
    return fs::path(KERF_SOURCE_DIR) / "assets/sessions" / (name + ".kerf.json");
}

TEST(ShippedSessions, AreReadWithoutWarnings) {
    std::set<std::string> names;
    for (const auto& entry :
         fs::directory_iterator(fs::path(KERF_SOURCE_DIR) / "assets/sessions")) {
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

class FoundSessions : public GlTest {
  protected:
    static ReplayResult replay(const std::string& name) {
        const Session session =
            readSession(fs::path(KERF_SOURCE_DIR) / ("tests/sessions/" + name + ".kerf.json"));
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

class ShippedModels : public GlTest, public ::testing::WithParamInterface<Bar> {};

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
        largest =
            std::max(largest, rmsShapeError(mesh.restPositions(), mesh.positions(), vertices));
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
