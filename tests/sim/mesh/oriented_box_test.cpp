#include "sim/mesh/oriented_box.h"

#include "sim/mesh/thickness.h"
#include "tests/support/body_upload.h"

namespace kerf {
namespace {

class OrientedBoxes : public ::testing::Test {
  protected:
    std::mt19937_64 random{20251120};
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    Vec3 randomPoint(double size) {
        return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
    }
    OrientedBox randomBox() {
        const Vec3 axis = randomPoint(1).normalized();
        const Eigen::AngleAxisd turn(uniform(0, 6.28), axis);
        return {randomPoint(1.2), turn.toRotationMatrix(),
                Vec3(uniform(0, 1), uniform(0, 1), uniform(0, 0.3))};
    }
};

Vec3 closestIn(const OrientedBox& box, const Vec3& p) {
    const Vec3 local = box.axes.transpose() * (p - box.center);
    return box.center + box.axes * Vec3(local.cwiseMax(-box.half).cwiseMin(box.half));
}

/// Distance of two boxes by projecting to and fro, which converges for convex sets.
double distance(const OrientedBox& a, const OrientedBox& b) {
    Vec3 p = a.center;
    Vec3 q = b.center;
    for (int i = 0; i < 20000; ++i) {
        q = closestIn(b, p);
        p = closestIn(a, q);
    }
    return (p - q).norm();
}

TEST_F(OrientedBoxes, OverlapExactlyWhereTheirDistanceIsZero) {
    int apart = 0;
    int together = 0;
    for (int i = 0; i < 300; ++i) {
        const OrientedBox a = randomBox();
        const OrientedBox b = randomBox();
        const double gap = distance(a, b);
        if (gap > 1e-3) {
            ++apart;
            EXPECT_FALSE(overlap(a, b)) << "pair " << i << " of seed 20251120, gap " << gap;
        } else if (gap < 1e-7) {
            ++together;
            EXPECT_TRUE(overlap(a, b)) << "pair " << i << " of seed 20251120";
        }
        EXPECT_EQ(overlap(a, b), overlap(b, a));
    }
    EXPECT_GT(apart, 50);
    EXPECT_GT(together, 30);
}

TEST_F(OrientedBoxes, EdgesAcrossNeedTheAxisAcrossBoth) {
    // Two bars, one turned by 90 degrees, edges facing each other: only the cross product of the
    // edges separates them.
    OrientedBox a{Vec3::Zero(), Eigen::Matrix3d::Identity(), Vec3(1, 0.1, 0.1)};
    a.axes = Eigen::AngleAxisd(0.785398, Vec3::UnitX()).toRotationMatrix();
    OrientedBox b{Vec3(0, 0, 0.29), Eigen::Matrix3d::Identity(), Vec3(0.1, 1, 0.1)};
    b.axes = Eigen::AngleAxisd(0.785398, Vec3::UnitY()).toRotationMatrix();
    EXPECT_FALSE(overlap(a, b));
    b.center.z() = 0.27;
    EXPECT_TRUE(overlap(a, b));
}

TEST_F(OrientedBoxes, ThatMeetOneOfManyAreNotMissed) {
    int found = 0;
    int told = 0;
    for (int i = 0; i < 50; ++i) {
        const OrientedBox box = randomBox();
        const MeetingBoxes meeting(box);
        for (int k = 0; k < 200; ++k) {
            const Vec3 low = randomPoint(2);
            const Bounds bounds{low, low + randomPoint(0.5).cwiseAbs()};
            const bool meets = meeting.mayMeet(bounds);
            told += mayMeet(box, bounds);
            found += meets;
            EXPECT_TRUE(meets || !mayMeet(box, bounds)) << "pair " << i << ", " << k;
        }
    }
    EXPECT_GT(told, 100);
    EXPECT_LE(found, told + told / 100);
}

TEST_F(OrientedBoxes, ParallelOnesThatTouchOverlap) {
    const OrientedBox a{Vec3::Zero(), Eigen::Matrix3d::Identity(), Vec3(1, 1, 1)};
    OrientedBox b = a;
    b.center.x() = 2;
    EXPECT_TRUE(overlap(a, b));
    b.center.x() = 2.001;
    EXPECT_FALSE(overlap(a, b));
}

TEST_F(OrientedBoxes, HoldTheirPointsAndFollowTheirSpread) {
    for (int i = 0; i < 50; ++i) {
        const OrientedBox around = randomBox();
        std::vector<Vec3> points;
        points.reserve(200);
        for (int k = 0; k < 200; ++k) {
            points.push_back(around.center + around.axes * Vec3(uniform(-4, 4), uniform(-1, 1),
                                                                uniform(-0.1, 0.1)));
        }
        const OrientedBox box = orientedBoxOf(points);
        for (const Vec3& p : points) {
            const Vec3 local = (box.axes.transpose() * (p - box.center)).cwiseAbs();
            EXPECT_TRUE((local.array() <= box.half.array() + 1e-12).all());
        }
        EXPECT_LT(box.half.prod(), 2 * 4 * 1 * 0.1) << "set " << i << " of seed 20251120";
    }
}

TEST_F(OrientedBoxes, OfOnePointAndOfALine) {
    const std::vector<Vec3> point{Vec3(1, 2, 3)};
    EXPECT_EQ(orientedBoxOf(point).half, Vec3::Zero());
    const std::vector<Vec3> line{Vec3(0, 0, 0), Vec3(1, 1, 0)};
    const OrientedBox box = orientedBoxOf(line);
    EXPECT_NEAR(box.half.maxCoeff(), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(box.half.minCoeff(), 0, 1e-12);
}

TEST(Thickness, OfASlabIsItsHeightOnItsFaces) {
    const SurfaceMesh slab = box(Vec3(1, 1, 0.2), 4);
    const std::vector<float> thickness = surfaceThickness(slab);
    ASSERT_EQ(thickness.size(), 2U * slab.vertexCount());
    int inside = 0;
    for (int v = 0; v < slab.vertexCount(); ++v) {
        const Vec3& p = slab.position(v);
        EXPECT_EQ(thickness[2 * v + 1], -1) << "there are no walls";
        if (std::abs(p.x()) < 0.49 && std::abs(p.y()) < 0.49) {
            EXPECT_NEAR(thickness[2 * v], 0.2, 1e-6);
            ++inside;
        }
    }
    EXPECT_GT(inside, 0);
}

TEST(Thickness, OfASphereIsItsDiameterEverywhere) {
    const SurfaceMesh ball = icosphere(4, 0.5);
    const std::vector<float> thickness = surfaceThickness(ball);
    for (int v = 0; v < ball.vertexCount(); ++v) {
        EXPECT_NEAR(thickness[2 * v], 1, 0.01);
    }
}

TEST(Thickness, OfARingIsThatOfItsTubeOnItsOutside) {
    const SurfaceMesh ring = torus(64, 32, 0.35, 0.15);
    const std::vector<float> thickness = surfaceThickness(ring);
    for (int v = 0; v < ring.vertexCount(); ++v) {
        if (std::hypot(ring.position(v).x(), ring.position(v).z()) > 0.499) {
            EXPECT_NEAR(thickness[2 * v], 0.3, 0.005) << "not that of the whole ring";
        }
    }
}

TEST(Thickness, HasNoGapsAlongTheRimOfACut) {
    const SurfaceMesh opened = openedSphere(8, 0.05, 0.25);
    const std::vector<float> thickness = surfaceThickness(opened);
    for (const int t : livingTriangles(opened)) {
        const int kind = opened.kind(t) == SurfaceKind::wall ? 1 : 0;
        for (const int v : opened.triangle(t)) {
            EXPECT_GE(thickness[2 * v + kind], 0) << "vertex " << v << " kind " << kind;
            EXPECT_LE(thickness[2 * v + kind], 1.01);
        }
    }
}

TEST(Thickness, IsEvenAlongTheRimOfACut) {
    const SurfaceMesh opened = openedSphere(8, 0.05, 0.25);
    const std::vector<float> thickness = surfaceThickness(opened);
    const auto atRim = [&](int v) { return thickness[2 * v] >= 0 && thickness[2 * v + 1] >= 0; };
    std::map<int, std::vector<float>> beside;  // of the skin
    for (const int t : livingTriangles(opened)) {
        for (const int v : opened.triangle(t)) {
            for (const int w : opened.triangle(t)) {
                if (opened.kind(t) == SurfaceKind::skin && atRim(v) && !atRim(w)) {
                    beside[v].push_back(thickness[2 * w]);
                }
            }
        }
    }
    EXPECT_GT(beside.size(), 10U);
    for (const auto& [v, values] : beside) {
        EXPECT_GE(thickness[2 * v], std::ranges::min(values)) << v;
        EXPECT_LE(thickness[2 * v], std::ranges::max(values)) << v;
    }
}

TEST(Thickness, CanBeGivenUp) {
    const SurfaceMesh ball = cubeSphere(8);
    EXPECT_THROW(surfaceThickness(ball, [](double) { throw std::runtime_error("enough"); }),
                 std::runtime_error);
}

struct Expected {
    std::string name;
    double maxEdgeRatio;    ///< longest to shortest edge of the whole model
    double minHeightRatio;  ///< height to longest edge of the worst triangle
};

std::ostream& operator<<(std::ostream& out, const Expected& expected) {
    return out << expected.name;
}

class BuiltinModel : public ::testing::TestWithParam<Expected> {};

struct Evenness {
    double shortest = std::numeric_limits<double>::max();
    double longest = 0;
    double heightRatio = 1;
};

Evenness measureEvenness(const TriangleSoup& soup) {
    Evenness even;
    for (const auto& [a, b, c] : soup.triangles) {
        const Vec3 ab = soup.positions[b] - soup.positions[a];
        const Vec3 bc = soup.positions[c] - soup.positions[b];
        const Vec3 ca = soup.positions[a] - soup.positions[c];
        const double longest = std::max({ab.norm(), bc.norm(), ca.norm()});
        even.shortest = std::min({even.shortest, ab.norm(), bc.norm(), ca.norm()});
        even.longest = std::max(even.longest, longest);
        even.heightRatio = std::min(even.heightRatio, ab.cross(ca).norm() / (longest * longest));
    }
    return even;
}

TEST_P(BuiltinModel, IsOneClosedPieceWithoutHandlesAMetreLongAroundTheOrigin) {
    const TriangleSoup soup = builtinSoup(GetParam().name);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.pieces, 1);
    EXPECT_EQ(report.vertices - report.triangles / 2, 2) << "Euler characteristic";
    EXPECT_EQ(checkClosedManifold(builtin(GetParam().name)), "");
    EXPECT_LT(report.bounds.center().norm(), 1e-5);
    EXPECT_NEAR((report.bounds.high - report.bounds.low).maxCoeff(), 1, 0.2);
}

TEST_P(BuiltinModel, IsEvenlyMeshed) {
    const Evenness even = measureEvenness(builtinSoup(GetParam().name));
    EXPECT_LT(even.longest / even.shortest, GetParam().maxEdgeRatio);
    EXPECT_GT(even.heightRatio, GetParam().minHeightRatio);
}

INSTANTIATE_TEST_SUITE_P(Assets, BuiltinModel,
                         ::testing::Values(Expected{"sphere20", 1.001, 0.86},
                                           Expected{"sphere80", 1.2, 0.7},
                                           Expected{"sphere768", 2, 0.45},
                                           Expected{"banana", 2, 0.4}, Expected{"octopus", 2, 0.4}),
                         [](const auto& test) { return test.param.name; });

TEST(BuiltinModels, ScriptMakesTheCommittedFiles) {
    KERF_BY_NIGHT();  // neither script nor files change by themselves
    if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) {
        GTEST_SKIP() << "python3-numpy is not installed; the script needs it";
    }
    const TemporaryFolder made;
    const fs::path folder = fs::path(KERF_SOURCE_DIR) / "assets" / "models";
    const std::string command = "/usr/bin/python3 -B '" + (folder / "make_models.py").string() +
                                "' '" + made.path().string() + "' >/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    for (const char* name : {"sphere20", "sphere80", "sphere768", "banana", "octopus"}) {
        const std::string file = std::string(name) + ".obj";
        EXPECT_TRUE(readBytes(folder / file) == readBytes(made / file)) << file;
    }
}

}  // namespace
}  // namespace kerf
