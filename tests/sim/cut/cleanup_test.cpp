#include "sim/cut/cleanup/cleanup.h"

#include "sim/cut/cleanup/workspace.h"

namespace kerf {
namespace {

constexpr double kWallEdge = 0.07;
const Vec3 kCenter(0.013, 0.021, 0.034);

CutSettings settingsWith(bool cleanUp) {
    CutSettings settings = exactSettings();
    settings.wallEdgeLength = kWallEdge;
    settings.cleanUp = cleanUp;
    return settings;
}

Stroke through(const Vec3& along, const Vec3& travel) {
    return straightStroke(kCenter, along, travel, 3.0, 2.4, 50);
}

/// From above, the tip at height 0.1 and then deeper, turning.
Stroke incision() {
    Stroke stroke;
    for (int i = 0; i <= 30; ++i) {
        const double u = i / 30.0;
        const double x = -0.7 + 1.1 * u;
        stroke.push_back({{x, 1.5, 0.011}, {x + 0.1 * u, 0.1 - 0.15 * u, 0.013 + 0.1 * u * u}});
    }
    return stroke;
}

/// Strokes on one body; the last one is cleaned.
struct Case {
    const char* name;
    SurfaceMesh mesh;
    std::vector<Stroke> strokes;
};

std::vector<Case> cases() {
    const Stroke down = through(Vec3::UnitX(), -Vec3::UnitY());
    const Stroke aside = through(Vec3(1, 0.2, 0.1).normalized(), Vec3(-0.1, 0.03, 1).normalized());
    return {{"sphere, right through", icosphere(3), {down}},
            {"coarse sphere, right through", icosphere(0), {down}},
            {"torus, right through", test::torus(), {aside}},
            {"bent tube, right through", bentTube(), {down}},
            {"sphere, incision", icosphere(3), {incision()}},
            {"sphere, across a cut", icosphere(3), {down, aside}},
            {"sphere, incision across a cut", icosphere(3), {aside, incision()}}};
}

struct Cleaned {
    SurfaceMesh before;
    SurfaceMesh after;
    CutDelta delta;
    CleanupStatistics statistics;
    std::vector<int> made;  ///< triangles from the first of the last stroke on
};

/// Cuts without clean-up, then cleans what the last stroke made.
Cleaned cleanAtEnd(const Case& c) {
    SurfaceMesh mesh = c.mesh;
    Cutter cutter(mesh, settingsWith(false));
    for (std::size_t i = 0; i + 1 < c.strokes.size(); ++i) {
        EXPECT_EQ(runStroke(cutter, mesh, c.strokes[i]).problem, "");
    }
    const cut::EdgeLengthField edgeLengths(kWallEdge);
    cut::Cleanup cleanup(mesh, edgeLengths);
    const int first = mesh.triangleSlots();
    EXPECT_EQ(runStroke(cutter, mesh, c.strokes.back()).problem, "");
    Cleaned result{mesh, mesh, {}, {}, {}};
    result.delta.firstNewVertex = mesh.vertexCount();
    result.statistics = cleanup.atEnd(result.delta);
    result.after = mesh;
    for (int t = first; t < mesh.triangleSlots(); ++t) {
        result.made.push_back(t);
    }
    return result;
}

/// `tolerance`: of current volumes, as a share.
void expectEqualPieces(const SurfaceMesh& before, const SurfaceMesh& after, double tolerance) {
    const PieceMap old = findPieces(before);
    const PieceMap now = findPieces(after);
    ASSERT_EQ(now.pieces.size(), old.pieces.size());
    // Numbered by their lowest vertex, which may have gone; every living vertex stays in its piece.
    for (int v = 0; v < after.vertexCount(); ++v) {
        if (now.ofVertex[v] < 0) {
            continue;
        }
        const Piece& a = old.pieces[old.ofVertex[v]];
        const Piece& b = now.pieces[now.ofVertex[v]];
        ASSERT_NEAR(b.volume, a.volume, tolerance * a.volume);
        ASSERT_NEAR(b.restVolume, a.restVolume, 1e-6 * a.restVolume);
    }
}

TEST(Cleanup, LeavesHardlyASliver) {
    StrokeQuality before;
    StrokeQuality after;
    for (const Case& c : cases()) {
        const Cleaned cleaned = cleanAtEnd(c);
        before.add(qualityOf(cleaned.before, cleaned.made));
        after.add(qualityOf(cleaned.after, cleaned.made));
    }
    EXPECT_GT(before.all().below002, before.all().triangles / 50) << "the cases hold slivers";
    EXPECT_GT(before.all().below0001, 0);
    EXPECT_LE(after.all().below002, 0.002 * after.all().triangles);
    EXPECT_EQ(after.all().below0001, 0);
}

/// At rest [m].
double shortestEdge(const SurfaceMesh& mesh, int t) {
    const Triangle& c = mesh.triangle(t);
    const auto length = [&](int i, int j) {
        return (mesh.restPosition(c[i]) - mesh.restPosition(c[j])).norm();
    };
    return std::min({length(0, 1), length(1, 2), length(2, 0)});
}

/// Of the triangles that are left, how many have an edge shorter than this [m].
int countShort(const SurfaceMesh& mesh, const std::vector<int>& triangles, double length) {
    return static_cast<int>(std::ranges::count_if(
        triangles, [&](int t) { return mesh.alive(t) && shortestEdge(mesh, t) < length; }));
}

struct Segment {
    Vec3 a, b;
};

/// Edges between skin and walls: the outline of the wound.
std::vector<Segment> rimOf(const SurfaceMesh& mesh) {
    std::vector<Segment> rim;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.alive(h / 3) && mesh.kind(h / 3) == SurfaceKind::skin &&
            mesh.kind(mesh.twin(h) / 3) == SurfaceKind::wall) {
            rim.push_back({mesh.position(mesh.origin(h)), mesh.position(mesh.target(h))});
        }
    }
    return rim;
}

double distance(const Vec3& p, const Segment& s) {
    const Vec3 ab = s.b - s.a;
    const double t = std::clamp((p - s.a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    return (p - s.a - t * ab).norm();
}

/// The farthest of points along `from` from `to`.
double farthest(const std::vector<Segment>& from, const std::vector<Segment>& to) {
    double most = 0;
    for (const Segment& s : from) {
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            const Vec3 p = s.a + t * (s.b - s.a);
            double least = 1e300;
            for (const Segment& other : to) {
                least = std::min(least, distance(p, other));
            }
            most = std::max(most, least);
        }
    }
    return most;
}

TEST(Cleanup, KeepsTheOutlineOfTheWound) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Cleaned cleaned = cleanAtEnd(c);
        const std::vector<Segment> before = rimOf(cleaned.before);
        const std::vector<Segment> after = rimOf(cleaned.after);
        EXPECT_LT(after.size(), before.size());
        // Each point is held to the limit; the way between two may deviate by a little more.
        const double most = 1.5 * cut::kMostDeviation * kWallEdge;
        EXPECT_LT(farthest(before, after), most);
        EXPECT_LT(farthest(after, before), most);
    }
}

bool sameTriangle(const SurfaceMesh& a, const SurfaceMesh& b, int t) {
    if (a.alive(t) != b.alive(t) || !a.alive(t)) {
        return a.alive(t) == b.alive(t);
    }
    for (int i = 0; i < 3; ++i) {
        const int v = b.triangle(t)[i];
        if (a.triangle(t)[i] != v || a.position(v) != b.position(v) ||
            a.restPosition(v) != b.restPosition(v)) {
            return false;
        }
    }
    return true;
}

void expectNamesAllThatChanged(const CutDelta& delta, const SurfaceMesh& before,
                               const SurfaceMesh& after) {
    const std::set<int> removed(delta.removedTriangles.begin(), delta.removedTriangles.end());
    const std::set<int> changed(delta.changedTriangles.begin(), delta.changedTriangles.end());
    const std::set<int> moved(delta.movedVertices.begin(), delta.movedVertices.end());
    const std::set<int> dead(delta.deadVertices.begin(), delta.deadVertices.end());
    EXPECT_TRUE(delta.addedTriangles.empty());
    ASSERT_EQ(after.triangleSlots(), before.triangleSlots());
    for (int t = 0; t < after.triangleSlots(); ++t) {
        EXPECT_EQ(removed.count(t) > 0, before.alive(t) && !after.alive(t));
        if (after.alive(t) && !sameTriangle(before, after, t)) {
            EXPECT_EQ(changed.count(t), 1u) << t;
        }
    }
    for (int v = 0; v < after.vertexCount(); ++v) {
        const bool lives = after.outgoing(v) >= 0;
        EXPECT_EQ(dead.count(v) > 0, before.outgoing(v) >= 0 && !lives);
        if (lives && before.position(v) != after.position(v)) {
            EXPECT_EQ(moved.count(v), 1u) << v;
        }
    }
}

/// Somewhere else, with every vertex and its copies moved by up to `noise` [m].
void crumple(SurfaceMesh& mesh, double noise) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double phase = mesh.firstCopy(v);
        const Vec3 way(std::sin(7.1 * phase), std::sin(3.3 * phase + 1), std::cos(5.7 * phase));
        mesh.setPosition(v, mesh.restPosition(v) + Vec3(5, -3, 2) + noise * way);
    }
}

/// Triangle slots from `first` on.
std::vector<int> slotsFrom(const SurfaceMesh& mesh, int first) {
    std::vector<int> slots(mesh.triangleSlots() - first);
    std::iota(slots.begin(), slots.end(), first);
    return slots;
}

TEST(Cleanup, KeepsTheMeshClosedAndEveryPiecesVolumeAndNamesAllThatChanged) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Cleaned cleaned = cleanAtEnd(c);
        EXPECT_GT(cleaned.statistics.collapses, 0);
        EXPECT_EQ(checkClosedManifold(cleaned.after), "");
        EXPECT_EQ(checkMirroredWalls(cleaned.after), "");
        EXPECT_LT(cleaned.statistics.volumeSpent, 1e-6);
        expectEqualPieces(cleaned.before, cleaned.after, 1e-6);
        expectNamesAllThatChanged(cleaned.delta, cleaned.before, cleaned.after);
    }
}

// Without a stroke, where the body stays folded: judged by the rest shape.
TEST(Cleanup, MendingRemovesShortEdgesOfACrumpledBody) {
    int before = 0;
    int after = 0;
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        SurfaceMesh mesh = c.mesh;
        const int first = mesh.triangleSlots();
        Cutter cutter(mesh, settingsWith(true));
        for (const Stroke& stroke : c.strokes) {
            ASSERT_EQ(runStroke(cutter, mesh, stroke).problem, "");
        }
        crumple(mesh, 0.02 * kWallEdge);
        const SurfaceMesh cut = mesh;
        const std::vector<int> made = slotsFrom(mesh, first);
        before += countShort(cut, made, 0.2 * kWallEdge);
        const CutDelta delta = cutter.mend(made);
        after += countShort(mesh, made, 0.2 * kWallEdge);
        expectNamesAllThatChanged(delta, cut, mesh);
        EXPECT_EQ(checkClosedManifold(mesh), "");
        EXPECT_EQ(checkMirroredWalls(mesh), "");
        expectEqualPieces(cut, mesh, 1e-4);
    }
    EXPECT_GT(before, 100);
    EXPECT_LT(after, before / 3) << "of " << before;
}

TEST(Cleanup, MendingIsPartOfIt) {
    SurfaceMesh mesh = icosphere(3);
    const int first = mesh.triangleSlots();
    Cutter cutter(mesh, settingsWith(false));
    runStroke(cutter, mesh, incision());
    const std::string before = fingerprint(mesh);
    EXPECT_TRUE(cutter.mend(slotsFrom(mesh, first)).empty());
    EXPECT_EQ(fingerprint(mesh), before);
}

TEST(Cleanup, CopiesStayAtOnePlace) {
    SurfaceMesh mesh = icosphere(3);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setVelocity(v, mesh.position(v).cross(Vec3(0.3, -0.2, 0.5)));
    }
    Cutter cutter(mesh, settingsWith(true));
    const CutCheck check = runStroke(cutter, mesh, incision());
    EXPECT_EQ(check.problem, "");
    EXPECT_GT(check.cleanup.collapses, 3);
    EXPECT_GT(check.cleanup.slides, 0);
    int copies = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const int point = mesh.firstCopy(v);
        copies += point != v;
        EXPECT_EQ(mesh.position(v), mesh.position(point));
        EXPECT_EQ(mesh.restPosition(v), mesh.restPosition(point));
        EXPECT_EQ(mesh.velocity(v), mesh.velocity(point));
    }
    EXPECT_GT(copies, 20);
}

// What lies at the rung decides where the next step cuts.
TEST(Cleanup, ChangesNothingAtTheFront) {
    SurfaceMesh mesh = icosphere(3);
    SurfaceMesh plain = mesh;
    Cutter cutter(mesh, settingsWith(true));
    Cutter plainCutter(plain, settingsWith(false));
    const Stroke stroke = through(Vec3::UnitX(), -Vec3::UnitY());
    cutter.begin(stroke.front());
    plainCutter.begin(stroke.front());
    int collapses = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        collapses += cutter.advance(stroke[i]).statistics.cleanup.collapses;
        plainCutter.advance(stroke[i]);
        ASSERT_EQ(cutter.rung().size(), plainCutter.rung().size());
        for (std::size_t k = 0; k < cutter.rung().size(); ++k) {
            const RungNode& node = cutter.rung()[k];
            EXPECT_LT((node.position - plainCutter.rung()[k].position).norm(), 1e-4 * kWallEdge);
            if (node.vertex >= 0) {
                EXPECT_EQ(node.position, mesh.position(node.vertex));
            }
        }
    }
    EXPECT_GT(collapses, 0);
}

TEST(Cleanup, SwitchedOffChangesNothing) {
    SurfaceMesh mesh = icosphere(3);
    Cutter cutter(mesh, settingsWith(false));
    const CutCheck check = runStroke(cutter, mesh, incision());
    EXPECT_GT(check.cuts, 5);
    EXPECT_EQ(check.cleanup.collapses + check.cleanup.flips + check.cleanup.slides, 0);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        EXPECT_GE(mesh.outgoing(v), 0);
    }
}

/// Each piece turned and stretched, and moved by `gap` [m] against the first one.
void deform(SurfaceMesh& mesh, const Eigen::Matrix3d& deformation, const Vec3& gap) {
    const PieceMap pieces = findPieces(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (pieces.ofVertex[v] >= 0) {
            mesh.setPosition(v, deformation * mesh.restPosition(v) + pieces.ofVertex[v] * gap);
        }
    }
}

double largestDifference(const SurfaceMesh& mesh, const SurfaceMesh& expected) {
    double most = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        for (const int v : mesh.alive(t) ? mesh.triangle(t) : Triangle{0, 0, 0}) {
            most = std::max(most, (mesh.position(v) - expected.position(v)).norm());
        }
    }
    return most;
}

// Else a body that is cut at rest jumps: sides that lie apart went each its own way, while at rest,
// where they lie at one place, they went together.
TEST(Cleanup, KeepsShapesAlikeWherePiecesLieApart) {
    Eigen::Matrix3d deformation;
    deformation << 0.1, -1.0, 0.0, 1.05, 0.1, 0.0, 0.05, 0.0, 0.97;
    const Vec3 gap(0.01 * kWallEdge, 0.02 * kWallEdge, 0);
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        SurfaceMesh mesh = c.mesh;
        const cut::EdgeLengthField edgeLengths(kWallEdge);
        cut::Cleanup cleanup(mesh, edgeLengths);
        Cutter cutter(mesh, settingsWith(false));
        for (const Stroke& stroke : c.strokes) {
            ASSERT_EQ(runStroke(cutter, mesh, stroke).problem, "");
        }
        deform(mesh, deformation, gap);
        CutDelta delta;
        EXPECT_GT(cleanup.atEnd(delta).collapses, 0);
        SurfaceMesh expected = mesh;
        deform(expected, deformation, gap);
        EXPECT_LT(largestDifference(mesh, expected), 1e-3 * kWallEdge);
    }
}

// Rest positions are moved by the same arithmetic as positions then, or a body at rest would begin
// to move.
TEST(Cleanup, LeavesWhatLiesAtRestAtRestToTheLastBit) {
    for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0.9, 0.1, -0.3), Vec3(0.2, 0.3, 1)}) {
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, settingsWith(true));
        const Stroke stroke =
            through(along.normalized(), along.cross(Vec3(0.2, 1, 0.37)).normalized());
        int slides = 0;
        eachStep(cutter, stroke,
                 [&](const CutResult& result) { slides += result.statistics.cleanup.slides; });
        EXPECT_GT(slides, 0);
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.outgoing(v) >= 0) {
                ASSERT_EQ(mesh.position(v), mesh.restPosition(v)) << v;
                ASSERT_TRUE(mesh.velocity(v).isZero(0)) << v;
            }
        }
    }
}

/// A square plate of side 4 and height 0.2 with a round bore of radius 1, as CAD programs make
/// them: short edges around the bore, long triangles beside it.
TriangleSoup platedBore(int sides) {
    TriangleSoup soup;
    const auto angle = [&](int i) { return 2 * M_PI * i / sides; };
    for (const double z : {-0.1, 0.1}) {
        for (int i = 0; i < sides; ++i) {
            soup.positions.emplace_back(std::cos(angle(i)), std::sin(angle(i)), z);
        }
        for (const double x : {-2.0, 2.0}) {
            for (const double y : {-2.0, 2.0}) {
                soup.positions.emplace_back(x, y, z);
            }
        }
    }
    const int upper = sides + 4;
    const auto corner = [&](int i) {  // nearest to the side of the bore from i
        const double middle = angle(i) + M_PI / sides;
        return sides + (std::cos(middle) > 0 ? 2 : 0) + (std::sin(middle) > 0 ? 1 : 0);
    };
    const auto addBoth = [&](int a, int b, int c) {
        soup.triangles.push_back({a + upper, b + upper, c + upper});
        soup.triangles.push_back({a, c, b});
    };
    const auto addWall = [&](int a, int b) {
        soup.triangles.push_back({a, b, b + upper});
        soup.triangles.push_back({a, b + upper, a + upper});
    };
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        addBoth(next, i, corner(i));
        if (corner(i) != corner(next)) {
            addBoth(next, corner(i), corner(next));
            addWall(corner(i), corner(next));
        }
        addWall(next, i);
    }
    return soup;
}

TEST(Cleanup, SkinFarFromTheCutKeepsItsVertices) {
    SurfaceMesh mesh = meshOf(platedBore(128));
    const std::vector<Vec3> before = mesh.restPositions();
    const CutCheck check = runStroke(
        mesh, CutSettings{}, straightStroke({1.4, 0, 0}, Vec3::UnitZ(), Vec3::UnitY(), 3, 5, 30));
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(piecesOf(mesh), 2);
    for (int v = 0; v < static_cast<int>(before.size()); ++v) {
        EXPECT_GE(mesh.outgoing(v), 0) << "vertex " << v;
        EXPECT_EQ(mesh.restPosition(v), before[v]) << "vertex " << v;
    }
}

}  // namespace
}  // namespace kerf
