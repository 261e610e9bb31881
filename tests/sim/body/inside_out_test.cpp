#include <gtest/gtest.h>

#include "sim/body/folded_triangles.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using Map = std::function<Vec3(const Vec3&)>;

std::vector<double> sharesWhere(SurfaceMesh mesh, const Map& place) {
    const BodyModel model = buildBodyModel(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, place(mesh.restPosition(v)));
    }
    return sharesInsideOut(model, mesh);
}

double shareWhere(const Map& place) {
    return sharesWhere(test::cubeSphere(8), place).at(0);
}

TEST(InsideOut, IsNothingOfABodyThatIsBentTwistedOrStretched) {
    EXPECT_EQ(shareWhere([](const Vec3& p) { return p; }), 0);
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(-p.y(), p.x() + 5, p.z()); }), 0);
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(4 * p.x(), 0.3 * p.y(), p.z()); }), 0);
    EXPECT_EQ(
        shareWhere([](const Vec3& p) { return Vec3(Eigen::AngleAxisd(p.x(), Vec3::UnitX()) * p); }),
        0);
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(p.x(), p.y() + p.x() * p.x(), p.z()); }),
              0);
}

TEST(InsideOut, IsAllOfAMirroredBody) {
    EXPECT_EQ(shareWhere([](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); }), 1);
}

TEST(InsideOut, IsThePartThatWentThroughTheRest) {
    const double share = shareWhere([](const Vec3& p) {
        return Vec3(p.x(), p.y() > 0.3 ? 0.6 - 4 * p.y() : p.y(), p.z());  // the cap, far below
    });
    EXPECT_GT(share, 0.1);
    EXPECT_LT(share, 0.8);
}

TEST(InsideOut, IsToldOfEachPiece) {
    const SurfaceMesh two =
        test::meshOf(test::joined(test::icosphereSoup(1), test::icosphereSoup(1), {3, 0, 0}));
    const std::vector<double> shares = sharesWhere(
        two, [](const Vec3& p) { return p.x() > 1.5 ? Vec3(p.x(), -p.y(), p.z()) : p; });
    EXPECT_EQ(shares, (std::vector<double>{0, 1}));
}

}  // namespace
}  // namespace kerf
