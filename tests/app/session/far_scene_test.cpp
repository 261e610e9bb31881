// Where a scene lies makes no difference: models far from the origin are cut as beside it, and come
// back with the numbers of their files.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "app/cli/replay/replay.h"
#include "app/files/export/export.h"
#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "sim/base/math.h"
#include "tests/support/fuzz_seed.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/nightly.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using Json = nlohmann::json;

Json listOf(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// A body about the origin, and a blade that goes through it on a straight way.
struct CutScene {
    SurfaceMesh mesh;
    Blade from;
    Blade to;
};

/// With a diagonal of 1, in floats.
SurfaceMesh bodyOfSizeOne(int kind) {
    TriangleSoup soup = kind == 0   ? test::icosphereSoup(2)
                        : kind == 1 ? test::torusSoup(20, 10)
                        : kind == 2 ? test::bentTubeSoup()
                                    : test::boxSoup(Vec3(1, 0.01, 0.7), 6);
    const double size = boxOf(soup.positions).diagonal();
    for (Vec3& p : soup.positions) {
        p = nearestFloats(p / size);
    }
    return test::meshOf(soup);
}

CutScene randomScene(std::mt19937& engine) {
    std::uniform_real_distribution<double> share(-1, 1);
    const auto direction = [&] {
        return Vec3(share(engine), share(engine), share(engine)).normalized();
    };
    const Vec3 along = direction();
    const Vec3 travel = along.cross(direction()).normalized();
    const Vec3 middle = 0.1 * direction();
    const Vec3 turned = (along + 0.2 * direction()).normalized();
    return {bodyOfSizeOne(static_cast<int>(engine() % 4)),
            {middle - along - travel, middle + along - travel},
            {middle - turned + travel, middle + turned + travel}};
}

class FarScene : public test::GlTest {
  protected:
    /// Replays the scene where it lies moved by `offset`.
    RunSummary run(const CutScene& scene, const Vec3& offset) {
        const std::filesystem::path model = folder / "model.ply";
        writeOutputFile(
            model, encodeMesh(scene.mesh, findPieces(scene.mesh), MeshFormat::ply, {}, offset));
        const auto pose = [&](int step, const Blade& blade) {
            return Json{{"step", step},
                        {"type", "blade"},
                        {"a", listOf(blade.a + offset)},
                        {"b", listOf(blade.b + offset)}};
        };
        const Json session = {{"format", "kerf-session"},
                              {"version", 1},
                              {"model", {{"path", model.string()}}},
                              {"params", {{"gravity", {0, 0, 0}}, {"floor", nullptr}}},
                              {"steps", 14},
                              {"events",
                               {{{"step", 0}, {"type", "hold"}},
                                pose(1, scene.from),
                                pose(12, scene.to),
                                {{"step", 13}, {"type", "lift"}},
                                {{"step", 14}, {"type", "export"}, {"file", "cut.ply"}}}}};
        const Session parsed = parseSession(session.dump(), folder.path());
        ModelMesh loaded = loadSessionModel(parsed);
        remarks = loaded.remarks;
        return replaySession(parsed, std::move(loaded), folder / "out", {}).summary;
    }

    static std::vector<double> volumesOf(const RunSummary& summary) {
        std::vector<double> volumes;
        for (const Piece& piece : summary.pieces) {
            volumes.push_back(piece.volume);
        }
        std::ranges::sort(volumes);
        return volumes;
    }

    test::TemporaryFolder folder;
    std::vector<std::string> remarks;
};

TEST_F(FarScene, RandomStrokesCutTheSameWhereverTheyAre) {
    const std::uint32_t first = test::fuzzSeed(4900);
    const int runs = test::runs("KERF_FUZZ_RUNS", 6, 120);
    for (int i = 0; i < runs; ++i) {
        std::mt19937 engine(first + static_cast<std::uint32_t>(i));
        const CutScene scene = randomScene(engine);
        const std::vector<double> here = volumesOf(run(scene, Vec3::Zero()));
        for (const double offset : {500.0, 1e4, 5e6}) {
            const RunSummary far = run(scene, offset * Vec3(1, -0.9, 0.1));
            EXPECT_TRUE(far.messages.empty()) << far.messages.front();
            const std::vector<double> there = volumesOf(far);
            ASSERT_EQ(there.size(), here.size()) << "seed " << first + i << " at " << offset;
            for (std::size_t p = 0; p < here.size(); ++p) {
                // Doubles are so far apart there.
                EXPECT_NEAR(there[p], here[p], 1e-6 + offset * 0x1p-51)
                    << "seed " << first + i << " at " << offset;
            }
        }
    }
}

TEST_F(FarScene, AtMapCoordinatesVerticesKeepTheNumbersOfTheFile) {
    std::mt19937 engine(1);
    CutScene scene = randomScene(engine);
    scene.mesh = bodyOfSizeOne(0);
    const Vec3 offset(500123.25, 5000456.5, 312.125);
    EXPECT_EQ(run(scene, offset).pieces.size(), 2U);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_TRUE(remarks.front().starts_with("The scene lies 50254")) << remarks.front();
    const std::vector<Vec3> before = importModel(folder / "model.ply").positions;
    const std::vector<Vec3> after = importModel(folder / "out/cut.ply").positions;
    const auto kept = std::ranges::count_if(
        before, [&](const Vec3& place) { return std::ranges::find(after, place) != after.end(); });
    EXPECT_GT(kept, 0.9 * double(before.size())) << "of " << before.size();
}

TEST_F(FarScene, WhatFloatsWouldMakeAnotherShapeOfIsRefused) {
    const SurfaceMesh ball = test::icosphere(2);
    const std::filesystem::path file = folder / "far.stl";
    writeOutputFile(file, encodeMesh(ball, findPieces(ball), MeshFormat::stl, {}, Vec3(5e6, 0, 0)));
    try {
        importModel(file);
        FAIL() << "read as floats";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("export it as PLY or OBJ"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace kerf::app
