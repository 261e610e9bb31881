#include "app/practice/cut_measure.h"

#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

constexpr double kTop = 0.5;   // of a cube of 1 m
constexpr double kAt = 0.013;  // z of most cuts [m]

/// A body that is cut for a task: what lies within `lump` [m] of the origin is model 1, else 0.
class PracticeBody {
  public:
    explicit PracticeBody(SurfaceMesh whole, double lump = 0)
        : uncut_(std::move(whole)), mesh_(uncut_), lump_(lump) {}

    void cut(const Stroke& way) {
        const CutCheck check = runStroke(cutter_, mesh_, way);
        ASSERT_EQ(check.problem, "");
        ASSERT_EQ(check.refused, 0) << check.reason;
        ASSERT_GT(check.cuts, 0);
    }
    CutScore score(const Task& task) { return measureCut(view(task)); }
    std::vector<RimDeviation> rim(const Task& task) { return rimDeviations(view(task)); }
    SurfaceMesh& mesh() { return mesh_; }

  private:
    using CutCheck = test::CutCheck;

    std::vector<int> membersOf(const SurfaceMesh& mesh) const {
        std::vector<int> members(mesh.triangleSlots(), -1);
        for (const int t : livingTriangles(mesh)) {
            const Corners at = restCornersOf(mesh, t);
            members[t] = ((at[0] + at[1] + at[2]) / 3).norm() < lump_ ? 1 : 0;
        }
        return members;
    }
    TaskBody view(const Task& task) {
        members_ = membersOf(mesh_);
        uncutMembers_ = membersOf(uncut_);
        return {task, mesh_, uncut_, members_, uncutMembers_};
    }

    SurfaceMesh uncut_;
    SurfaceMesh mesh_;
    double lump_;
    Cutter cutter_{mesh_, CutSettings{}};
    std::vector<int> members_;
    std::vector<int> uncutMembers_;
};

PracticeBody cube() {
    return PracticeBody(box(Vec3::Ones(), 6));
}

/// A cube with a ball of radius 0.08 m in a cavity in its middle.
PracticeBody cubeWithLump() {
    const TriangleSoup hollow =
        joined(boxSoup(Vec3::Ones(), 6), turned(icosphereSoup(2, 0.105)), Vec3::Zero());
    return PracticeBody(meshOf(joined(hollow, icosphereSoup(2, 0.08), Vec3::Zero())), 0.09);
}

/// Downwards across the whole cube in the plane z = `z`, to `depth` below its top [m].
Stroke downTo(double depth, double z = kAt) {
    const double above = 0.2;
    return straightStroke({0.01, kTop + (above - depth) / 2, z}, Vec3::UnitX(), -Vec3::UnitY(), 2,
                          above + depth, static_cast<int>(60 * (above + depth)));
}

/// By an upright blade that reaches `depth` below the top, from one place there to another [m].
Stroke drawn(const Vec3& from, const Vec3& to, double depth) {
    Stroke stroke;
    const int steps = static_cast<int>(std::ceil(60 * (to - from).norm()));
    for (int i = 0; i <= steps; ++i) {
        const Vec3 at = from + (to - from) * i / steps;
        stroke.push_back({at + Vec3(0, 0.2, 0), at - Vec3(0, depth, 0)});
    }
    return stroke;
}

/// All around the middle, right through.
Stroke around(double radius, double turns = 1) {
    constexpr int kRound = 88;
    Stroke stroke;
    for (int i = 0; i <= turns * kRound; ++i) {
        const double angle = 2 * std::numbers::pi * (i % kRound) / kRound + 0.01;
        const Vec3 at(radius * std::cos(angle), 0, radius * std::sin(angle));
        stroke.push_back({at + Vec3::UnitY(), at - Vec3::UnitY()});
    }
    return stroke;
}

/// To cut along x, over the cube.
Task taskOf(double fromX, double toX, double z = kAt) {
    Task task;
    task.lines = {{{{fromX, kTop, z}, {toX, kTop, z}}}};
    task.reach = 0.1;
    return task;
}

Task deep(Task task, double depth, double band) {
    task.depth = depth;
    task.band = band;
    return task;
}

TEST(CutMeasure, AStraightCutAlongTheLineHasNoDeviation) {
    PracticeBody body = cube();
    body.cut(downTo(0.3));
    const CutScore score = body.score(deep(taskOf(-0.5, 0.5), 0.3, 0.01));
    EXPECT_LT(*score.deviationMax, 1e-3);
    EXPECT_LE(*score.deviationMean, *score.deviationMax);
    EXPECT_NEAR(*score.depthMean, 0.3, 2e-3);
    EXPECT_EQ(*score.depthInBand, 1);
    EXPECT_NEAR(*score.lengthUnder, 0, 1e-3);
    EXPECT_NEAR(*score.lengthOver, 0, 1e-9);
    EXPECT_FALSE(score.marginLeast || score.taken || score.excisedVolume);
    EXPECT_EQ(score.sparedCut, 0);
    EXPECT_EQ(*body.score(deep(taskOf(-0.5, 0.5), 0.25, 0.04)).depthInBand, 0);
    EXPECT_FALSE(body.score(taskOf(-0.5, 0.5)).depthMean) << "right through";
}

TEST(CutMeasure, AStraightCutBesideTheLineDeviatesByItsOffset) {
    PracticeBody body = cube();
    body.cut(downTo(0.3, kAt + 0.04));
    const CutScore score = body.score(deep(taskOf(-0.4, 0.4), 0.3, 0.01));
    EXPECT_NEAR(*score.deviationMean, 0.04, 1e-3);
    EXPECT_NEAR(*score.deviationMax, 0.04, 1e-3);
    EXPECT_NEAR(*score.depthMean, 0.3, 2e-3);
    EXPECT_NEAR(*score.lengthUnder, 0, 1e-9);
}

// As large as those of the tasks: what a perfect hand is found to deviate.
TEST(CutMeasure, ACutOfAPadIsMeasuredToAFewHundredthsOfAMillimetre) {
    PracticeBody body(box({0.12, 0.02, 0.08}, 24));
    Stroke stroke;
    for (int i = 0; i <= 150; ++i) {
        const Vec3 at(-0.075 + 0.001 * i, 0.01, 0.0021);
        stroke.push_back({at + Vec3(0, 0.02, 0), at - Vec3(0, 0.005, 0)});
    }
    body.cut(stroke);
    Task task;
    task.lines = {{{{-0.035, 0.01, 0.0006}, {0.035, 0.01, 0.0006}}}};
    const CutScore score = body.score(deep(task, 0.005, 0.0002));
    EXPECT_NEAR(*score.deviationMean, 0.0015, 2e-5);
    EXPECT_NEAR(*score.deviationMax, 0.0015, 5e-5);
    EXPECT_NEAR(*score.depthMean, 0.005, 5e-5);
    EXPECT_EQ(*score.depthInBand, 1);
    EXPECT_NEAR(*score.lengthOver, 0.05 + 2 * 0.005, 5e-4);
}

TEST(CutMeasure, ASlantedCutDeviatesMoreAndMore) {
    PracticeBody body = cube();
    body.cut(drawn({-0.7, kTop, kAt - 0.07}, {0.7, kTop, kAt + 0.07}, 0.3));
    const CutScore score = body.score(deep(taskOf(-0.4, 0.4), 0.3, 0.01));
    EXPECT_NEAR(*score.deviationMean, 0.02, 1e-3);
    EXPECT_NEAR(*score.deviationMax, 0.04, 1e-3);
}

TEST(CutMeasure, ALeaningCutDeviatesByItsRimAlone) {
    PracticeBody body = cube();
    const Vec3 lean(0, 0.5, 0.1);
    Stroke stroke;
    for (int i = 0; i <= 80; ++i) {
        const Vec3 at(-0.7 + 1.4 * i / 80, kTop, kAt);
        stroke.push_back({at + 0.4 * lean, at - 0.6 * lean});
    }
    body.cut(stroke);
    const CutScore score = body.score(deep(taskOf(-0.4, 0.4), 0.3, 0.01));
    EXPECT_LT(*score.deviationMax, 1e-3);
    EXPECT_NEAR(*score.depthMean, 0.3, 2e-3);
}

TEST(CutMeasure, DepthIsNotMeasuredWhereABladeSwingsIn) {
    PracticeBody body = cube();
    Stroke stroke;
    for (int i = 0; i <= 84; ++i) {
        const double x = -0.7 + 1.4 * i / 84;
        const double depth = std::clamp(0.4 - std::abs(x), -0.1, 0.2);
        stroke.push_back({{x, kTop + 0.2, kAt}, {x, kTop - depth, kAt}});
    }
    body.cut(stroke);
    const CutScore score = body.score(deep(taskOf(-0.4, 0.4), 0.2, 0.01));
    EXPECT_NEAR(*score.depthMean, 0.2, 3e-3);
    EXPECT_GT(*score.depthInBand, 0.95);
    EXPECT_NEAR(*score.lengthUnder, 0, 0.02);
    EXPECT_LT(*body.score(deep(taskOf(-0.4, 0.4), 0.02, 0.01)).depthMean, 0.17);
}

TEST(CutMeasure, HalfTheLengthLeavesHalfOfTheLine) {
    PracticeBody body = cube();
    body.cut(drawn({-0.8, kTop, kAt}, {0, kTop, kAt}, 0.3));
    const CutScore score = body.score(deep(taskOf(-0.4, 0.4), 0.3, 0.01));
    EXPECT_NEAR(*score.lengthUnder, 0.4, 0.01);
    EXPECT_LT(*score.deviationMax, 1e-3);
    EXPECT_NEAR(*score.depthMean, 0.3, 5e-3) << "only where it is cut";
    EXPECT_NEAR(*score.lengthOver, 0.1 + 0.3, 0.03) << "to the border of the cube and down";
}

TEST(CutMeasure, RimsBeyondTheEndsAreOver) {
    PracticeBody body = cube();
    body.cut(straightStroke({0, kTop, kAt}, Vec3::UnitX(), -Vec3::UnitY(), 0.6, 0.4, 24));
    const CutScore longer = body.score(taskOf(-0.2, 0.2));
    EXPECT_NEAR(*longer.lengthOver, 0.2, 0.01);
    EXPECT_NEAR(*longer.lengthUnder, 0, 1e-9);
    EXPECT_LT(*longer.deviationMax, 1e-3);
    const CutScore shorter = body.score(taskOf(-0.4, 0.4));
    EXPECT_NEAR(*shorter.lengthUnder, 0.2, 0.01);
    EXPECT_NEAR(*shorter.lengthOver, 0, 1e-9);
    Task other = taskOf(-0.2, 0.2);
    other.model = 1;
    EXPECT_EQ(*body.score(other).lengthOver, 0) << "another model is to be cut";
}

TEST(CutMeasure, OfTwoSlitsTheFartherCountsAndOneBeyondReachIsOver) {
    PracticeBody body = cube();
    body.cut(downTo(0.3));
    body.cut(downTo(0.3, kAt + 0.07));
    const Task near = taskOf(-0.5, 0.5);
    EXPECT_NEAR(*body.score(near).deviationMax, 0.07, 1e-3);
    EXPECT_NEAR(*body.score(near).deviationMean, 0.07, 2e-3);
    EXPECT_NEAR(*body.score(near).lengthOver, 0, 1e-9);

    Task narrow = near;
    narrow.reach = 0.05;
    const CutScore score = body.score(narrow);
    EXPECT_LT(*score.deviationMax, 1e-3);
    EXPECT_NEAR(*score.lengthOver, 1 + 2 * 0.3, 5e-3) << "over the top and down both sides";
}

TEST(CutMeasure, ACutBelongsToTheNearerOfTwoLines) {
    PracticeBody body = cube();
    body.cut(downTo(0.3, 0.01));
    body.cut(downTo(0.2, 0.08));
    Task task = deep(taskOf(-0.5, 0.5, 0), 0.3, 0.01);
    task.lines.push_back(taskOf(-0.5, 0.5, 0.1).lines[0]);
    const CutScore score = body.score(task);
    EXPECT_NEAR(*score.deviationMax, 0.02, 1e-3);
    EXPECT_NEAR(*score.deviationMean, 0.015, 1e-3);
    EXPECT_NEAR(*score.depthMean, 0.25, 2e-3);
    EXPECT_NEAR(*score.depthInBand, 0.5, 1e-2);
    EXPECT_NEAR(*score.lengthOver, 0, 1e-9);
}

TEST(CutMeasure, NothingCutHasNoDeviationAndLeavesTheWholeLine) {
    PracticeBody body = cube();
    Task task = deep(taskOf(-0.5, 0.2), 0.3, 0.01);
    task.spareRegions = {Ball{Vec3::Zero(), 0.1}};
    const CutScore score = body.score(task);
    EXPECT_FALSE(score.deviationMean || score.deviationMax || score.depthMean ||
                 score.depthInBand || score.marginLeast);
    EXPECT_NEAR(*score.lengthUnder, 0.7, 1e-9);
    EXPECT_EQ(*score.lengthOver, 0);
    EXPECT_FALSE(body.score(Task{}).lengthUnder) << "no line";
}

TEST(CutMeasure, ReadsTheRestShapeOnly) {
    PracticeBody body = cube();
    body.cut(downTo(0.3, kAt + 0.04));
    Task task = deep(taskOf(-0.4, 0.4), 0.3, 0.01);
    task.spareRegions = {Ball{Vec3::Zero(), 0.1}};
    const CutScore before = body.score(task);
    for (int v = 0; v < body.mesh().vertexCount(); ++v) {
        body.mesh().setPosition(v, 2 * body.mesh().position(v) + Vec3::Ones());
    }
    const CutScore after = body.score(task);
    EXPECT_EQ(before.deviationMean, after.deviationMean);
    EXPECT_EQ(before.depthMean, after.depthMean);
    EXPECT_EQ(before.lengthOver, after.lengthOver);
    EXPECT_EQ(before.marginLeast, after.marginLeast);
}

TEST(CutMeasure, TearsAreNoCuts) {
    PracticeBody body = cube();
    body.cut(downTo(0.3));
    body.mesh().noteTorn(body.mesh().vertexCount());
    Task task = taskOf(-0.5, 0.5);
    task.spare = {0};
    EXPECT_TRUE(body.score(task).deviationMax) << "none of its vertices is torn";
    body.mesh().noteTorn(0);
    EXPECT_FALSE(body.score(task).deviationMax);
    EXPECT_NEAR(*body.score(task).lengthUnder, 1, 1e-9);
    EXPECT_EQ(body.score(task).sparedCut, 1) << "but a tear does harm";
}

TEST(CutMeasure, MarginsToABallABoxAndAModel) {
    PracticeBody body = cubeWithLump();
    body.cut(downTo(1.5, 0.25));
    Task task;
    task.spareRegions = {Ball{{0, 0, -0.1}, 0.1}};
    EXPECT_NEAR(*body.score(task).marginLeast, 0.25, 5e-3);
    task.spareRegions = {Bounds{{-1, -1, 0.3}, {1, 1, 1}}};
    EXPECT_NEAR(*body.score(task).marginLeast, 0.05, 1e-3);
    task.spareRegions = {Bounds{{-1, -1, 0.1}, {1, 1, 0.26}}};
    EXPECT_NEAR(*body.score(task).marginLeast, -0.01, 1e-3) << "inside";
    task.spareRegions = {Ball{{0, 0, 0.25}, 0.2}};
    EXPECT_NEAR(*body.score(task).marginLeast, -0.2, 0.03) << "through its middle";

    task.spareRegions.clear();
    task.spare = {1};
    EXPECT_NEAR(*body.score(task).marginLeast, 0.25 - 0.08, 5e-3);
    EXPECT_EQ(body.score(task).sparedCut, 0);
    task.spareRegions = {Bounds{{-1, -1, 0.3}, {1, 1, 1}}};
    EXPECT_NEAR(*body.score(task).marginLeast, 0.05, 1e-3) << "the least of both";
}

TEST(CutMeasure, ARegionToSpareThatIsCutCounts) {
    PracticeBody body = cubeWithLump();
    body.cut(downTo(1.5, 0.25));
    Task task;
    for (const double radius : {0.003, 0.02, 0.2}) {
        task.spareRegions = {Ball{{0.013, 0.017, 0.25}, radius}};
        EXPECT_NEAR(*body.score(task).marginLeast, -radius, 1e-9);
        EXPECT_EQ(body.score(task).sparedCut, 1);
    }
    task.spareRegions = {Ball{{0, 0, 0.27}, 0.01}, Bounds{{-1, -1, 0.3}, {1, 1, 1}}};
    EXPECT_EQ(body.score(task).sparedCut, 0);
}

TEST(CutMeasure, AShortLineTakesNoLonger) {
    PracticeBody body = cube();
    body.cut(downTo(0.3));
    const Task task = taskOf(-1e-9, 1e-9);
    EXPECT_NEAR(*body.score(task).lengthUnder + *body.score(task).lengthOver, 1 + 2 * 0.3, 5e-3);
}

TEST(CutMeasure, ASparedModelThatIsCutHasNoMargin) {
    PracticeBody body = cubeWithLump();
    body.cut(downTo(1.5));
    Task task;
    task.spare = {1};
    task.take = 1;
    const CutScore score = body.score(task);
    EXPECT_EQ(score.sparedCut, 1);
    EXPECT_EQ(*score.marginLeast, 0);
    EXPECT_FALSE(*score.taken);
    EXPECT_FALSE(score.excisedVolume);
}

TEST(CutMeasure, ALumpInAPieceApartIsTaken) {
    PracticeBody body = cubeWithLump();
    Task task;
    task.take = 1;
    task.spare = {1};
    EXPECT_FALSE(*body.score(task).taken) << "nothing is cut";
    body.cut(around(0.3));
    const CutScore score = body.score(task);
    EXPECT_TRUE(*score.taken);
    const double cavity = meshRestVolume(icosphere(2, 0.105));
    EXPECT_NEAR(*score.excisedVolume, std::numbers::pi * 0.3 * 0.3 - cavity, 3e-3);
    EXPECT_NEAR(*score.marginLeast, 0.3 - 0.08, 5e-3);
}

TEST(CutMeasure, ALumpInTheRestOfTheBodyIsNotTaken) {
    Task task;
    task.take = 1;
    PracticeBody beside = cubeWithLump();
    beside.cut(downTo(1.5, 0.3));
    EXPECT_FALSE(*beside.score(task).taken) << "the smaller piece is without it";
    PracticeBody half = cubeWithLump();
    half.cut(around(0.3, 0.5));
    EXPECT_FALSE(*half.score(task).taken) << "half of the way around";
    PracticeBody laidBare = cubeWithLump();
    laidBare.cut(downTo(1.5, 0.095));
    EXPECT_FALSE(*laidBare.score(task).taken) << "its cavity is open";
}

TEST(CutMeasure, ALumpThatIsCutIsNotTakenWhole) {
    PracticeBody body = cubeWithLump();
    body.cut(straightStroke({0, 0.045, kAt}, Vec3::UnitX(), -Vec3::UnitY(), 0.05, 0.1, 40));
    body.cut(around(0.3));
    Task task;
    task.take = 1;
    EXPECT_FALSE(*body.score(task).taken) << "though its cavity is closed";
}

TEST(CutMeasure, DistancesAreSeenAlongTheDirectionIntoTheBody) {
    PracticeBody body = cube();
    body.cut(downTo(0.3, kAt + 0.04));
    Task task = deep(taskOf(-0.4, 0.4), 0.3, 0.01);
    task.lines[0].points = {{-0.4, -7, kAt}, {0.4, 3, kAt}};
    const CutScore above = body.score(task);
    EXPECT_NEAR(*above.deviationMax, 0.04, 1e-3);
    EXPECT_NEAR(*above.depthMean, 0.3, 2e-3);
    EXPECT_NEAR(*above.lengthUnder + *above.lengthOver, 0.2 + 2 * 0.3, 5e-3);

    // Seen at 45 degrees to the cut, a plane is as much farther off as its rim is behind it.
    task.lines[0].points = {{-0.4, kTop, kAt}, {0.4, kTop, kAt}};
    task.into = Vec3(0, -2, 2);
    task.reach = 0.3;
    EXPECT_NEAR(*body.score(task).deviationMax, 0.04 / std::sqrt(2), 1e-3);
}

TEST(CutMeasure, AClosedLineHasNoEnds) {
    PracticeBody body = cube();
    body.cut(around(0.3));
    Task square = deep(taskOf(0, 0), 1, 0.01);
    const double side = 0.3;
    square.lines[0].points = {{-side, kTop, -side}, {side, kTop, -side}, {side, kTop, side}};
    square.lines[0].points.emplace_back(-side, kTop, side);
    square.lines[0].closed = true;
    square.reach = 0.2;
    const CutScore closed = body.score(square);
    EXPECT_NEAR(*closed.deviationMax, 0.3 * (std::sqrt(2.0) - 1) * std::sqrt(0.5), 0.01);
    EXPECT_NEAR(*closed.lengthOver, 0, 1e-9);
    EXPECT_NEAR(*closed.depthMean, 1, 1e-4) << "right through";
    square.lines[0].closed = false;
    EXPECT_LT(*body.score(square).deviationMax, 0.2);
    EXPECT_GT(*body.score(square).lengthOver, 0.2) << "beyond its ends, and too far aside";
}

TEST(CutMeasure, TheRimHasItsDeviation) {
    PracticeBody body = cube();
    body.cut(downTo(0.3, kAt + 0.04));
    const std::vector<RimDeviation> rim = body.rim(taskOf(-0.2, 0.2));
    const SurfaceMesh& mesh = body.mesh();
    int within = 0;
    for (const auto& [h, deviation] : rim) {
        EXPECT_EQ(mesh.kind(SurfaceMesh::triangleOf(h)), SurfaceKind::wall);
        EXPECT_EQ(mesh.kind(SurfaceMesh::triangleOf(mesh.twin(h))), SurfaceKind::skin);
        const Vec3 middle =
            0.5 * (mesh.restPosition(mesh.origin(h)) + mesh.restPosition(mesh.target(h)));
        EXPECT_EQ(deviation.has_value(), std::abs(middle.x()) < 0.2) << middle.transpose();
        EXPECT_NEAR(deviation.value_or(0.04), 0.04, 1e-3);
        within += deviation ? 1 : 0;
    }
    EXPECT_GT(within, 5);
    EXPECT_GT(rim.size(), within + 5U) << "beyond the line there are edges, too";
    EXPECT_FALSE(body.rim(Task{}).front().deviation) << "no line, no deviation";
}

}  // namespace
}  // namespace kerf::app
