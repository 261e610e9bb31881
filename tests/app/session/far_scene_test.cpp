// Where a scene lies makes no difference: models far from the origin are cut as beside it, and come
// back with the numbers of their files.
#include "app/session/scene_origin.h"

namespace kerf::app {
namespace {

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
    TriangleSoup soup = kind == 0   ? icosphereSoup(2)
                        : kind == 1 ? torusSoup(20, 10)
                        : kind == 2 ? bentTubeSoup()
                                    : boxSoup(Vec3(1, 0.01, 0.7), 6);
    const double size = boxOf(soup.positions).diagonal();
    for (Vec3& p : soup.positions) {
        p = nearestFloats(p / size);
    }
    return meshOf(soup);
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

class FarScene : public GlTest {
  protected:
    /// Replays the scene where it lies moved by `offset`.
    RunSummary run(const CutScene& scene, const Vec3& offset) {
        const fs::path model = folder / "model.ply";
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
    const std::uint32_t first = fuzzSeed(4900);
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
    const std::vector<Vec3> before = importModel(folder / "model.ply").model.soup.positions;
    const std::vector<Vec3> after = importModel(folder / "out/cut.ply").model.soup.positions;
    const auto kept = std::ranges::count_if(
        before, [&](const Vec3& place) { return std::ranges::find(after, place) != after.end(); });
    EXPECT_GT(kept, 0.9 * double(before.size())) << "of " << before.size();
}

TEST_F(FarScene, WhatFloatsWouldMakeAnotherShapeOfIsRefused) {
    const SurfaceMesh ball = icosphere(2);
    const fs::path file = folder / "far.stl";
    writeOutputFile(file, encodeMesh(ball, findPieces(ball), MeshFormat::stl, {}, Vec3(5e6, 0, 0)));
    EXPECT_THAT(inputErrorOf([&] { importModel(file); }), HasSubstr("export it as PLY or OBJ"));
}

// Places that are counted from a point beside the models, and from 0 in files.

const Vec3 kMap(500096, 304, -5000192);

TEST(SceneOrigin, SessionsAreWrittenAsTheyWereRead) {
    for (const std::string& text : {sessionWithEveryKey(), sessionWithEveryEvent()}) {
        const Session read = parseSession(text, "/");
        const Session near = withOrigin(read, Vec3(64, -128, 512));
        EXPECT_EQ(near.origin, Vec3(64, -128, 512));
        const Session again = parseSession(formatSession(near, "/"), "/");
        const std::string asWritten = formatSession(withOrigin(again, Vec3(64, -128, 512)), "/");
        EXPECT_EQ(asWritten, formatSession(near, "/"));
        EXPECT_EQ(formatSession(withOrigin(near, Vec3::Zero()), "/"), formatSession(near, "/"));
    }
}

TEST(SceneOrigin, AnOriginAtZeroChangesNoBit) {
    for (const std::string& text : {sessionWithEveryKey(), sessionWithEveryEvent()}) {
        const Session read = parseSession(text, "/");
        EXPECT_EQ(formatSession(withOrigin(read, Vec3::Zero()), "/"), formatSession(read, "/"));
    }
    const Command minusZero = Drag{0, Vec3(-0.0, 1, 2)};
    const auto same = std::get<Drag>(asReplayed(minusZero, Vec3::Zero()));
    EXPECT_TRUE(std::signbit(same.to.x()));
}

TEST(SceneOrigin, WhatIsAPlaceMovesAndWhatIsNoneStays) {
    const Vec3 by(1, 10, 100);
    const auto moved = [&](const Command& command) { return countedFrom(command, by); };
    const Vec3 at(5, 6, 7);
    const Vec3 there(4, -4, -93);
    const auto blade = std::get<MoveBlade>(moved(MoveBlade{{at, Vec3(1, 10, 100)}})).blade;
    EXPECT_EQ(blade.a, there);
    EXPECT_EQ(blade.b, Vec3(0, 0, 0));
    EXPECT_EQ(std::get<Grab>(moved(Grab{1, at, 0.5})).at, there);
    EXPECT_EQ(std::get<Drag>(moved(Drag{1, at})).to, there);
    EXPECT_EQ(std::get<Ball>(std::get<Pin>(moved(Pin{Ball{at, 2}})).region).center, there);
    const auto box = std::get<Bounds>(std::get<Pin>(moved(Pin{Bounds{at, 2 * at}})).region);
    EXPECT_EQ(box.low, there);
    EXPECT_EQ(box.high, Vec3(9, 2, -86));
    EXPECT_EQ(std::get<AddBox>(moved(AddBox{{at, Vec3::Ones()}})).box.center, there);
    EXPECT_EQ(std::get<ChangeBox>(moved(ChangeBox{0, {at, Vec3::Ones()}})).box.center, there);
    EXPECT_EQ(std::get<MovePins>(moved(MovePins{at})).by, at);
    EXPECT_EQ(std::get<SetParam>(moved(SetParam{"gravity", at})).value, ParamValue(at));
    EXPECT_EQ(std::get<SetParam>(moved(SetParam{"floor", 3.0})).value, ParamValue(-7.0));
    EXPECT_EQ(std::get<SetParam>(moved(SetParam{"damping", 3.0})).value, ParamValue(3.0));
    Placement placement;
    placement.translate = at;
    EXPECT_EQ(std::get<Place>(moved(Place{placement})).placement.translate, there);
    render::Camera camera;
    camera.target = at;
    EXPECT_EQ(countedFrom(camera, by).target, there);
    EXPECT_EQ(countedFrom(camera, by).up, camera.up);
}

// Else a person's cut would not be that of its replay.
TEST(SceneOrigin, WhatIsDoneIsWhatAFileSays) {
    std::mt19937_64 engine(fuzzSeed(1));
    std::normal_distribution<double> normal;
    const double scales[] = {1e-3, 1, 10, 1e6, 1e7};
    for (int i = 0; i < 10000; ++i) {
        const double scale = scales[i % std::size(scales)];
        const Command wanted =
            Drag{0, scale * Vec3(normal(engine), normal(engine), normal(engine))};
        const Command done = asReplayed(wanted, kMap);
        const SessionEvent event{0, std::get<Drag>(countedFrom(done, -kMap))};
        Session session = parseSession(sessionWith(""), "/");
        session.events = {event};
        const Session read = parseSession(formatSession(session, "/"), "/");
        const auto replayed = std::get<Drag>(withOrigin(read, kMap).events.front().action);
        ASSERT_EQ(replayed.to, std::get<Drag>(done).to) << i;
        ASSERT_NEAR((replayed.to - std::get<Drag>(wanted).to).norm(), 0, 1e-8 * (1 + scale));
    }
}

}  // namespace
}  // namespace kerf::app
