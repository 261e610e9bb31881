#include "tests/support/shell_lists.h"

namespace kerf {
namespace {

using Hinge = std::array<Vec3, 4>;

double angleOf(const Hinge& x) {
    return dihedral<double>(x[1] - x[0], x[2] - x[0], x[3] - x[0]).angle;
}

// Edge along x, apexes left and right, both lowered by `drop`: convex seen from above for drop > 0.
Hinge roof(double drop) {
    return {Vec3(0, 0, 0), {1, 0, 0}, {0.4, -drop, -1}, {0.6, -drop, 1}};
}

TEST(Dihedral, FlatIsZeroConvexIsPositiveConcaveNegative) {
    EXPECT_NEAR(angleOf(roof(0)), 0, 1e-15);
    EXPECT_NEAR(angleOf(roof(1)), std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(angleOf(roof(-1)), -std::numbers::pi / 2, 1e-12);
}

TEST(Dihedral, GradientAgreesWithFiniteDifferences) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> noise(-0.3, 0.3);
    const double step = 1e-6;
    for (int trial = 0; trial < 50; ++trial) {
        Hinge x = roof(2 * noise(random));
        for (Vec3& p : x) {
            p += Vec3(noise(random), noise(random), noise(random));
        }
        const auto exact = dihedral<double>(x[1] - x[0], x[2] - x[0], x[3] - x[0]);
        ASSERT_TRUE(exact.valid);
        for (int v = 0; v < 4; ++v) {
            for (int axis = 0; axis < 3; ++axis) {
                Hinge forward = x;
                Hinge back = x;
                forward[v][axis] += step;
                back[v][axis] -= step;
                const double slope = wrapAngle(angleOf(forward) - angleOf(back)) / (2 * step);
                EXPECT_NEAR(exact.gradient[v][axis], slope, 1e-6) << "seed 7, trial " << trial;
            }
        }
    }
}

TEST(Dihedral, CollinearPointsAreInvalidAndGiveNoNumber) {
    const auto folded = dihedral<double>(Vec3(1, 0, 0), Vec3(0.5, 0, 0), Vec3(0, 0, 1));
    EXPECT_FALSE(folded.valid);
    EXPECT_FALSE(dihedral<float>(Vec3f::Zero(), Vec3f::UnitX(), Vec3f::UnitZ()).valid);
}

TEST(Dihedral, DifferencesOfAnglesWrap) {
    EXPECT_NEAR(wrapAngle(1.9 * std::numbers::pi), -0.1 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(wrapAngle(-1.9 * std::numbers::pi), 0.1 * std::numbers::pi, 1e-12);
    EXPECT_EQ(wrapAngle(0.5), 0.5);
}

std::vector<int> everyVertex(const std::vector<Vec3>& points) {
    std::vector<int> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

TEST(ShapeError, IsZeroForARigidMotion) {
    const std::vector<Vec3> rest = bentTube(8, 6).restPositions();
    const Eigen::AngleAxisd turn(2.5, Vec3(1, -2, 0.5).normalized());
    std::vector<Vec3> moved;
    moved.reserve(rest.size());
    for (const Vec3& p : rest) {
        moved.push_back(turn * p + Vec3(3, -7, 11));
    }
    EXPECT_NEAR(rmsShapeError(rest, moved, everyVertex(rest)), 0, 1e-12);
}

TEST(ShapeError, SeesStretchAndAMirrorImage) {
    const std::vector<Vec3> rest = box().restPositions();
    std::vector<Vec3> stretched = rest;
    std::vector<Vec3> mirrored = bentTube(8, 6).restPositions();
    for (Vec3& p : stretched) {
        p.y() *= 1.2;
    }
    EXPECT_NEAR(rmsShapeError(rest, stretched, everyVertex(rest)), 0.1, 1e-12);
    const std::vector<Vec3> tube = mirrored;
    for (Vec3& p : mirrored) {
        p.y() *= -1;
    }
    mirrored[0].z() += 0.3;
    EXPECT_GT(rmsShapeError(tube, mirrored, everyVertex(tube)), 1e-3);
}

TEST(ShapeError, LooksAtTheSubsetOnly) {
    const std::vector<Vec3> rest = box().restPositions();
    std::vector<Vec3> moved = rest;
    moved[3] += Vec3(9, 9, 9);
    const std::vector<int> others = {0, 1, 2, 4, 5, 6, 7};
    EXPECT_NEAR(rmsShapeError(rest, moved, others), 0, 1e-12);
    EXPECT_EQ(rmsShapeError(rest, moved, {}), 0);
}

const std::vector<Vec3> kCorners{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-1, -2, 1}};

/// With weights 1, 2, 3, 4, moving with `motion` about their middle.
std::vector<FittedVertex> turned(const Eigen::Matrix3d& rotation, const Vec3& shift) {
    std::vector<FittedVertex> vertices;
    for (const Vec3& rest : kCorners) {
        const int number = static_cast<int>(vertices.size());
        vertices.push_back({number, number + 1.0, rotation * rest + shift, rest, Vec3::Zero()});
    }
    return vertices;
}

TEST(RestPose, OfARigidMotionIsThatMotion) {
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(2.5, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const std::vector<FittedVertex> vertices = turned(rotation, {4, 5, 6});
    const RestPose pose = fitRestPose(vertices);
    EXPECT_LT((pose.rotation - rotation).norm(), 1e-12);
    for (const FittedVertex& v : vertices) {
        EXPECT_LT((pose.placeOf(v.rest) - v.at).norm(), 1e-12);
    }
    EXPECT_LT(rmsWay(pose, vertices), 1e-12);
    EXPECT_GT(pose.radius, 1);
}

TEST(RestPose, NeverMirrors) {
    Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
    mirror(0, 0) = -1;
    const std::vector<FittedVertex> vertices = turned(mirror, Vec3::Zero());
    const RestPose pose = fitRestPose(vertices);
    EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-12);
    EXPECT_GT(rmsWay(pose, vertices), 0.3);
}

TEST(RestPose, WaysToItHaveNoMomentum) {
    std::vector<FittedVertex> vertices = turned(Eigen::Matrix3d::Identity(), Vec3::Zero());
    vertices[1].at += Vec3(0.3, -2, 0.4);
    vertices[2].at *= -0.5;
    const RestPose pose = fitRestPose(vertices);
    for (FittedVertex& v : vertices) {
        v.velocity = pose.placeOf(v.rest) - v.at;
    }
    const RigidMotion motion = rigidMotionOf(vertices, pose.middle);
    EXPECT_LT(motion.velocity.norm(), 1e-12);
    EXPECT_LT(motion.spin.norm(), 1e-5);
}

TEST(RestPose, MotionAsAWholeIsFound) {
    std::vector<FittedVertex> vertices = turned(Eigen::Matrix3d::Identity(), Vec3::Zero());
    const Vec3 middle = fitRestPose(vertices).middle;
    const Vec3 spin(0.1, -2, 3);
    for (FittedVertex& v : vertices) {
        v.velocity = Vec3(7, 8, 9) + spin.cross(v.at - middle);
    }
    const RigidMotion motion = rigidMotionOf(vertices, middle);
    EXPECT_LT((motion.velocity - Vec3(7, 8, 9)).norm(), 1e-12);
    EXPECT_LT((motion.spin - spin).norm(), 1e-4);
}

TEST(RestPose, OfAPointAloneMovesWithIt) {
    const std::vector<FittedVertex> one{{0, 2, {1, 2, 3}, {0, 0, 0}, {4, 5, 6}}};
    EXPECT_EQ(fitRestPose(one).placeOf(Vec3::Zero()), Vec3(1, 2, 3));
    EXPECT_EQ(rigidMotionOf(one, one[0].at).velocity, Vec3(4, 5, 6));
    EXPECT_EQ(rigidMotionOf(one, one[0].at).spin, Vec3::Zero());
}

TEST(RestGeometry, MeanEdgeOfAnIcosahedron) {
    EXPECT_NEAR(meanRestEdgeLength(icosphere(0, 0.5)), 0.5 / std::sin(2 * std::numbers::pi / 5),
                1e-12);
}

TEST(ConstraintBuilder, EveryEdgeOnceWithItsLengthAndCrossSection) {
    const SurfaceMesh mesh = box(Vec3::Ones(), 1);
    const double thickness = 0.1;
    const auto edges = buildEdges(mesh, thickness);
    ASSERT_EQ(edges.size(), 18u);
    for (const auto& e : edges) {
        const double length = (mesh.restPosition(e.a) - mesh.restPosition(e.b)).norm();
        EXPECT_FLOAT_EQ(e.rest_length, length);
        EXPECT_FLOAT_EQ(e.geometry, length * length / (thickness * 1.0));
    }
}

TEST(ConstraintBuilder, BendsOfABoxAreRightAnglesOrFlat) {
    const SurfaceMesh mesh = box(Vec3::Ones(), 1);
    int right = 0;
    const auto bends = buildBends(mesh, 0.1);
    ASSERT_EQ(bends.size(), 18u);
    for (const auto& b : bends) {
        const bool isRight = std::abs(b.rest_angle - std::numbers::pi / 2) < 1e-6;
        EXPECT_TRUE(isRight || std::abs(b.rest_angle) < 1e-6) << b.rest_angle;
        EXPECT_FLOAT_EQ(b.geometry, 1 / (0.3 * 0.001 / 12));
        right += isRight;
    }
    EXPECT_EQ(right, 12);
}

TEST(ConstraintBuilder, SliversGetEdgesButNoBends) {
    SurfaceMesh mesh = box(Vec3::Ones(), 1);
    const int sliver = 0;
    const Triangle t = mesh.triangle(sliver);
    const Vec3 middle = 0.5 * (mesh.restPosition(t[0]) + mesh.restPosition(t[1]));
    mesh.setRestPosition(t[2], middle + 0.01 * (mesh.restPosition(t[2]) - middle));
    EXPECT_EQ(buildEdges(mesh, 0.1).size(), 18u);
    const auto bends = buildBends(mesh, 0.1);
    EXPECT_LE(bends.size(), 15u);
    for (const auto& b : bends) {
        EXPECT_TRUE(std::isfinite(b.rest_angle));
    }
}

TEST(ConstraintBuilder, AnEdgeWithoutLengthStaysFinite) {
    SurfaceMesh mesh = box(Vec3::Ones(), 1);
    mesh.setRestPosition(1, mesh.restPosition(0));
    for (const auto& e : buildEdges(mesh, 0.1)) {
        EXPECT_TRUE(std::isfinite(e.geometry) && e.geometry >= 0) << e.a << " " << e.b;
    }
}

/// A vertex goes across the opposite edge of one of its triangles, which turns over.
SurfaceMesh foldedSphere(int vertex) {
    SurfaceMesh mesh = icosphere(2);
    const int h = mesh.next(mesh.outgoing(vertex));
    const Vec3 middle = 0.5 * (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h)));
    mesh.setPosition(vertex, 2.2 * middle - 1.2 * mesh.position(vertex));
    return mesh;
}

TEST(FoldedTriangles, AreThoseAroundWhatTurnedOver) {
    constexpr int kVertex = 30;
    const SurfaceMesh mesh = foldedSphere(kVertex);
    const std::vector<int> folded = foldedTriangles(mesh, 0);
    EXPECT_TRUE(std::ranges::binary_search(folded, mesh.outgoing(kVertex) / 3));
    EXPECT_LT(folded.size(), 40u);
    EXPECT_TRUE(std::ranges::is_sorted(folded));
}

TEST(FoldedTriangles, AreNoneWhereABodyOnlyTurnsAndStretches) {
    SurfaceMesh mesh = icosphere(2);
    const Eigen::AngleAxisd turn(2.5, Vec3(1, -2, 0.5).normalized());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 stretched = mesh.restPosition(v).cwiseProduct(Vec3(1.2, 0.8, 1.1));
        mesh.setPosition(v, turn * stretched);
    }
    EXPECT_TRUE(foldedTriangles(mesh, 0).empty());
}

TEST(FoldedTriangles, LieInNoSlotBeforeTheFirst) {
    constexpr int kVertex = 30;
    const SurfaceMesh mesh = foldedSphere(kVertex);
    const std::vector<int> all = foldedTriangles(mesh, 0);
    const int first = all[all.size() / 2];
    const std::vector<int> some = foldedTriangles(mesh, first);
    EXPECT_LT(some.size(), all.size());
    EXPECT_GE(some.front(), first);
    EXPECT_TRUE(foldedTriangles(mesh, mesh.triangleSlots()).empty());
}

/// The direction away from the slit in the plane z = 0 on which a vertex lies.
double sideOf(const SurfaceMesh& mesh, int vertex) {
    double side = mesh.restPosition(vertex).z();
    mesh.forEachOutgoing(vertex, [&](int h) {
        if (mesh.kind(h / 3) == SurfaceKind::wall) {
            side = -areaNormal(restCornersOf(mesh, h / 3)).z();
        }
    });
    return side > 0 ? 1 : -1;
}

TEST(FoldedTriangles, AreNotThoseAtTheEndOfASlitThatIsOpened) {
    SurfaceMesh mesh = icosphere(3);
    Cutter cutter(mesh, exactSettings());
    const Stroke down = straightStroke({0, 0.7, 0}, Vec3::UnitX(), -Vec3::UnitY(), 3, 1, 20);
    ASSERT_EQ(runStroke(cutter, mesh, down).problem, "");
    const std::vector<int> ends = slitHalfEdges(mesh, 0);
    ASSERT_FALSE(ends.empty());
    const double bottom = mesh.restPosition(mesh.origin(ends.front())).y();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3& rest = mesh.restPosition(v);
        const double opening = 1.2 * std::max(0.0, rest.y() - bottom);  // by 50 degrees each
        mesh.setPosition(v, rest + Vec3(0, 0, sideOf(mesh, v) * opening));
    }
    EXPECT_EQ(foldedTriangles(mesh, 0), std::vector<int>());
}

}  // namespace
}  // namespace kerf
