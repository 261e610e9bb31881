#include "sim/run/tear/weak_spot.h"

namespace kerf {
namespace {

void stretch(SurfaceMesh& mesh, const Eigen::Matrix3d& by) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, by * mesh.restPosition(v));
    }
}

TEST(WeakSpot, AStretchedBodyIsWeakAcrossTheStretchHoweverCurved) {
    for (SurfaceMesh mesh : {icosphere(2), torus(), box(Vec3::Ones(), 8)}) {
        stretch(mesh, Vec3(1.2, 1, 1).asDiagonal());
        EXPECT_FALSE(findWeakSpot(mesh, 0.201, {}));
        const auto found = findWeakSpot(mesh, 0.19, {});
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->along.x(), 0, 0.05);
        EXPECT_NEAR(found->normal.x(), 0, 0.15);
        EXPECT_FALSE(findWeakSpot(mesh, 0.19, {{Vec3::Zero()}, 2})) << "all of it is held";
    }
}

TEST(WeakSpot, NothingIsWeakThatOnlyTurnsOrAtOneVertex) {
    SurfaceMesh mesh = icosphere(2);
    stretch(mesh, Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix());
    EXPECT_FALSE(findWeakSpot(mesh, 1e-6, {}));
    stretch(mesh, Eigen::Matrix3d::Identity());
    mesh.setPosition(0, 1.2 * mesh.restPosition(0));
    EXPECT_FALSE(findWeakSpot(mesh, 0.2, {})) << "edges there are stretched more";
}

}  // namespace
}  // namespace kerf
