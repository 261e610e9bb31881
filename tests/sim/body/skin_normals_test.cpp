#include "sim/body/skin_normals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/sim/body/hand_cut.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

/// [degrees]
double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// A mesh cut along the loop of its edges in the plane y = 0, and the normals carried through.
class LoopCut {
  public:
    explicit LoopCut(SurfaceMesh whole) : mesh(std::move(whole)), normals(mesh) {
        const int vertices = mesh.vertexCount();
        std::vector<Triangle> old;
        old.reserve(mesh.triangleSlots());
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            old.push_back(mesh.triangle(t));
        }
        const test::HandCut cut(mesh);
        normals.follow(mesh, vertices, old);
    }
    bool atWound(int v) const {
        const Vec3& p = mesh.restPosition(v);
        return std::fabs(p.y()) < 1e-12 && p.norm() > 1e-12;
    }

    SurfaceMesh mesh;
    SkinNormals normals;
};

/// However large its triangles are.
class RoundSkin : public testing::TestWithParam<double> {};

TEST_P(RoundSkin, KeepsItsNormalAtAWound) {
    const LoopCut body(test::cubeSphere(8, GetParam()));
    int found = 0;
    for (int v = 0; v < body.mesh.vertexCount(); ++v) {
        const Vec3 normal = body.normals.ofCut(body.mesh, v);
        if (!body.atWound(v)) {
            EXPECT_EQ(normal, Vec3::Zero()) << "its triangles give it";
            continue;
        }
        ++found;
        EXPECT_LT(angleBetween(normal, body.mesh.restPosition(v)), 2) << v;
    }
    EXPECT_GT(found, 20);
}

INSTANTIATE_TEST_SUITE_P(Radius, RoundSkin, testing::Values(0.005, 0.5, 50.0));

TEST(SkinNormals, AHardEdgeHasNoNormalOfItsOwn) {
    const LoopCut body(test::box(Vec3::Ones(), 4));
    int flat = 0;
    int hard = 0;
    for (int v = 0; v < body.mesh.vertexCount(); ++v) {
        const Vec3& p = body.mesh.restPosition(v);
        if (!body.atWound(v)) {
            continue;
        }
        const bool atEdge = std::fabs(std::fabs(p.x()) - std::fabs(p.z())) < 1e-9;
        const Vec3 normal = body.normals.ofCut(body.mesh, v);
        if (atEdge) {
            EXPECT_EQ(normal, Vec3::Zero()) << v;
            ++hard;
            continue;
        }
        const bool alongX = std::fabs(p.x()) > std::fabs(p.z());
        const Vec3 outwards(alongX ? p.x() : 0, 0, alongX ? 0 : p.z());
        EXPECT_LT(angleBetween(normal, outwards), 0.1) << v;
        ++flat;
    }
    EXPECT_EQ(hard, 2 * 4);
    EXPECT_EQ(flat, 2 * 4 * 3);
}

}  // namespace
}  // namespace kerf
