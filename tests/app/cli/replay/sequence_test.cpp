// Meshes of a run on the way, and what other programs read in them.
#include "tests/app/cli/replay/small_session_fixture.h"

namespace kerf::app {
namespace {

class SequenceTest : public SmallSessionTest {
  protected:
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder_ / "out/sequence")) {
            all.push_back(entry.path().filename());
        }
        return all;
    }
};

TEST_F(SequenceTest, HasAMeshEverySoManyStepsAndOfTheEnd) {
    ASSERT_EQ(replay({"--sequence", "15", "--pieces"}).exitCode, 0);
    EXPECT_THAT(names(),
                UnorderedElementsAre("step-000000.ply", "step-000015.ply", "step-000030.ply",
                                     "step-000040.ply", "sequence.ply.series"));
    const auto series = Json::parse(readBytes(path("out/sequence/sequence.ply.series")));
    EXPECT_EQ(series["file-series-version"], "1.0");
    ASSERT_EQ(series["files"].size(), 4u);
    EXPECT_EQ(series["files"][1]["name"], "step-000015.ply");
    EXPECT_NEAR(series["files"][1]["time"].get<double>(), 0.075, 1e-12);
    const CsvTable pieces(path("out/pieces.csv"), 1 << 20);
    MeshReport report;
    loadModel(path("out/sequence/step-000015.ply"), &report);
    EXPECT_EQ(report.pieces, 2);
    double volume = 0;
    for (std::size_t row = 0; row < pieces.rows(); ++row) {
        const bool before = pieces.number(row, pieces.require("step")) == 14;
        volume += before ? pieces.number(row, pieces.require("volume")) : 0;
    }
    EXPECT_NEAR(report.volume, volume, 1e-5) << "as step 14 left it";
}

TEST_F(SequenceTest, AnEarlierOneGoesAndWhatIsOfOthersStays) {
    ASSERT_EQ(replay({"--sequence", "10", "--meshes", "vtp"}).exitCode, 0);
    EXPECT_TRUE(fs::exists(path("out/sequence/sequence.pvd")));
    writeText(path("out/sequence/notes.txt"), "mine");
    writeText(path("out/sequence/step-one.ply"), "mine");
    ASSERT_EQ(replay({"--sequence", "40", "--meshes", "OBJ"}).exitCode, 0);
    EXPECT_THAT(names(), UnorderedElementsAre("step-000000.obj", "step-000040.obj",
                                              "sequence.obj.series", "notes.txt", "step-one.ply"));
}

TEST_F(SequenceTest, ChangesNoState) {
    ASSERT_EQ(replay({"--hashes"}).exitCode, 0);
    const std::string hashes = readBytes(path("out/hashes.csv"));
    ASSERT_EQ(replay({"--hashes", "--sequence", "1", "--meshes", "stl"}).exitCode, 0);
    EXPECT_EQ(readBytes(path("out/hashes.csv")), hashes);
    EXPECT_EQ(names().size(), 42u);
}

/// What tests/app/files/export/read_mesh.py finds in a mesh, as a JSON object.
Json figuresOf(const std::string& file) {
    const std::string said =
        outputOf("/usr/bin/python3 -B '" KERF_SOURCE_DIR "/tests/app/files/export/read_mesh.py' '" +
                 file + "' 2>&1");
    return Json::parse(said, nullptr, false);
}

TEST_F(SequenceTest, EachFormatHasTheQuantitiesThatItCanHold) {
    for (const std::string format : {"vtp", "ply", "glb", "gltf"}) {
        SCOPED_TRACE(format);
        ASSERT_EQ(replay({"--sequence", "25", "--meshes", format, "--pieces"}).exitCode, 0);
        const CsvTable pieces(path("out/pieces.csv"), 1 << 20);
        const Json found = figuresOf(path("out/sequence/step-000040." + format));
        ASSERT_TRUE(found.is_object());
        ASSERT_EQ(found["volumes"].size(), 2u);
        for (std::size_t piece = 0; piece < 2; ++piece) {
            const std::size_t row = pieces.rows() - 2 + piece;
            const double volume = pieces.number(row, pieces.require("volume"));
            EXPECT_NEAR(found["volumes"][piece].get<double>(), volume, 1e-6);
            // Summed up over the triangles that the file has of the piece.
            EXPECT_NEAR(found["measured_volumes"][piece].get<double>(), volume, 1e-6);
        }
        EXPECT_GT(found["cut_faces"].get<int>(), 20);
        // It has fallen for 24 steps, from step 16 on.
        EXPECT_LT(found["mean_velocity"][1].get<double>(), -0.3);
        EXPECT_GT(found["mean_velocity"][1].get<double>(), -9.81 * 24 * 0.005);
        EXPECT_GT(found["most_strain"].get<double>(), 1e-4);
        EXPECT_LT(found["most_strain"].get<double>(), 1);
    }
}

TEST_F(SequenceTest, TheIndexOfParaViewNamesAllFiles) {
    ASSERT_EQ(replay({"--sequence", "20", "--meshes", "vtp"}).exitCode, 0);
    const std::string index = readBytes(path("out/sequence/sequence.pvd"));
    EXPECT_THAT(index, HasSubstr("<VTKFile type=\"Collection\""));
    EXPECT_THAT(index, HasSubstr("timestep=\"0\" part=\"0\" file=\"step-000000.vtp\""));
    EXPECT_THAT(index, HasSubstr("file=\"step-000020.vtp\""));
    EXPECT_THAT(index, HasSubstr("file=\"step-000040.vtp\""));
}

/// What tests/app/files/export/read_alembic.py finds in a cache.
Json cacheFigures(const std::string& file) {
    return Json::parse(outputOf("/usr/bin/python3 -B '" KERF_SOURCE_DIR
                                "/tests/app/files/export/read_alembic.py' '" +
                                file + "' 2>&1"),
                       nullptr, false);
}

TEST_F(SequenceTest, ACacheHasTheBodyOverTime) {
    const ProgramRun run = replay({"--cache", path("a.abc"), "--json"});
    ASSERT_EQ(run.exitCode, 0);
    EXPECT_EQ(Json::parse(run.out)["cache"]["samples"], 41);
    const Json found = cacheFigures(path("a.abc"));
    ASSERT_TRUE(found.is_object());
    EXPECT_EQ(found["samples"], 41);
    EXPECT_EQ(found["even"], true);
    EXPECT_NEAR(found["times"].back().get<double>(), 0.2, 1e-9);
    EXPECT_GT(found["faces"].back(), found["faces"].front()) << "triangles change";
    for (const Json& volume : found["volumes"]) {
        EXPECT_NEAR(volume.get<double>(), found["volumes"][0].get<double>(), 2e-3);
    }
    EXPECT_EQ(found["sets"]["cut"].front(), 0);
    EXPECT_GT(found["sets"]["cut"].back(), 20);
    EXPECT_EQ(found["sets"]["skin"].back().get<int>() + found["sets"]["cut"].back().get<int>(),
              found["faces"].back().get<int>());
    for (std::size_t sample = 14; sample <= 36; ++sample) {  // until it falls on the floor
        EXPECT_LT(found["velocity_errors"][sample].get<double>(), 9.81 * 0.005) << sample;
    }
    EXPECT_LT(found["fall"].get<double>(), -0.3);
    EXPECT_EQ(found["against_normals"].back(), 0);
    const Vec3 inner = render::toDisplay(render::BodyLook{}.inner);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(found["cut_color"][i].get<double>(), inner[i], 1e-4);
    }
    EXPECT_THAT(found["metadata"].get<std::string>(), HasSubstr("_ai_Application=Kerf"));
}

TEST_F(SequenceTest, ACacheWithFewerSamplesHasTheSameOnes) {
    ASSERT_EQ(replay({"--cache", path("a.ABC"), "--cache-every", "20"}).exitCode, 0);
    const Json found = cacheFigures(path("a.ABC"));
    EXPECT_EQ(found["samples"], 3);
    EXPECT_NEAR(found["times"].back().get<double>(), 0.2, 1e-9);
    EXPECT_THAT(replay({"--cache", path("b.abc")}).out, HasSubstr("b.abc, 41 samples"));
    EXPECT_EQ(cacheFigures(path("b.abc"))["faces"][20], found["faces"][1]);
}

TEST_F(SequenceTest, ACacheOfAPauseHasTheTimesOfAFilm) {
    writeText(folder_ / "test.kerf.json",
              R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere80"},
                  "params": {"gravity": [0, -9, 0], "floor": null}, "steps": 30, "events": [
                  {"step": 0, "type": "hold"},
                  {"step": 0, "type": "blade", "a": [-1, 1, 0.1], "b": [1, 1, 0.1]},
                  {"step": 20, "type": "blade", "a": [-1, -1, 0.1], "b": [1, -1, 0.1],
                   "seconds": 0.1},
                  {"step": 20, "type": "run"},
                  {"step": 21, "type": "lift"}]})");
    ASSERT_EQ(replay({"--cache", path("a.abc")}).exitCode, 0);
    const Json found = cacheFigures(path("a.abc"));
    EXPECT_EQ(found["even"], false);
    EXPECT_NEAR(found["times"].back().get<double>(), 1.955, 1e-9);
    EXPECT_LT(found["fall"].get<double>(), -0.2);
}

TEST_F(SequenceTest, MistakesOfACacheAreRefused) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
        {{"--cache", path("a.obj")}, "does not end in .abc"},
        {{"--cache", ""}, "does not end in .abc"},
        {{"--cache", path("a.abc"), "--cache-every", "0"}, "--cache-every"},
        {{"--cache-every", "2"}, "--cache"},
    };
    for (const auto& [options, words] : mistakes) {
        const ProgramRun run = replay(options);
        EXPECT_EQ(run.exitCode, 2) << options.back();
        EXPECT_THAT(run.errors, HasSubstr(words));
    }
    expectEnd(replay({"--cache", path("missing/a.abc")}), 5, "that folder doesn't exist");
    EXPECT_FALSE(fs::exists(path("missing")));
}

TEST_F(SequenceTest, MistakesAreRefused) {
    EXPECT_EQ(replay({"--sequence", "0"}).exitCode, 2);
    const ProgramRun unknown = replay({"--sequence", "5", "--meshes", "abc"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.errors,
                HasSubstr("'abc' is no format; there are obj, ply, stl, glb, gltf, vtp"));
    EXPECT_EQ(replay({"--meshes", "ply"}).exitCode, 2);
    EXPECT_FALSE(fs::exists(path("out")));
}

}  // namespace
}  // namespace kerf::app
