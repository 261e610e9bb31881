#include "sim/mesh/skin_attributes.h"

#include <gtest/gtest.h>

#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/triangle.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using Uv = Eigen::Vector2f;

/// Linear in the place, so that what is carried along can be told exactly; the part with x > 0 lies
/// elsewhere on the texture, behind a seam.
Uv uvAt(const Vec3& p, bool right) {
    const Vec3f q = p.cast<float>();
    return {0.3F * q.x() + 0.1F * q.z() + (right ? 5.0F : 0.0F), 0.2F * q.y() + 0.05F * q.z()};
}

std::vector<CornerUvs> linearUvs(const SurfaceMesh& mesh) {
    std::vector<CornerUvs> uvs;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        Vec3 middle = Vec3::Zero();
        for (const int v : mesh.triangle(t)) {
            middle += mesh.restPosition(v) / 3;
        }
        CornerUvs corners;
        for (int i = 0; i < 3; ++i) {
            corners[i] = uvAt(mesh.restPosition(mesh.triangle(t)[i]), middle.x() > 0);
        }
        uvs.push_back(corners);
    }
    return uvs;
}

void cutThrough(SurfaceMesh& mesh, const Vec3& from, const Vec3& to) {
    Cutter cutter(mesh, CutSettings{});
    const auto blade = [&](double share) {
        const Vec3 p = from + share * (to - from);
        return Blade{p - Vec3(0, 0, 2), p + Vec3(0, 0, 2)};
    };
    cutter.begin(blade(0));
    for (int i = 1; i <= 20; ++i) {
        cutter.advance(blade(i / 20.0));
    }
    cutter.finish();
}

TEST(SkinAttributes, AnUncutMeshKeepsItsOwn) {
    const SurfaceMesh mesh = test::box(Vec3::Ones(), 2);
    const SkinAttributes skin{.uvs = linearUvs(mesh), .colors = {}, .materials = {}};
    EXPECT_EQ(carrySkin(mesh, skin, mesh), skin);
    EXPECT_TRUE(carrySkin(mesh, {}, mesh).empty());
}

TEST(SkinAttributes, NewSkinGetsWhatItsPlaceHasAndWallsGetNone) {
    const SurfaceMesh uncut = test::box(Vec3::Ones(), 4);
    const std::vector<CornerUvs> uvs = linearUvs(uncut);
    SurfaceMesh cut = uncut;
    cutThrough(cut, Vec3(-0.83, 1.1, 0), Vec3(0.61, -1.2, 0));
    ASSERT_GT(cut.aliveTriangles(), uncut.aliveTriangles());
    const std::vector<CornerUvs> carried = carrySkin(uncut, {uvs, {}, {}}, cut).uvs;
    ASSERT_EQ(static_cast<int>(carried.size()), cut.triangleSlots());
    int newSkin = 0;
    for (int t = 0; t < cut.triangleSlots(); ++t) {
        if (!cut.alive(t)) {
            continue;
        }
        Vec3 middle = Vec3::Zero();
        for (const int v : cut.triangle(t)) {
            middle += cut.restPosition(v) / 3;
        }
        newSkin += t >= uncut.triangleSlots() && cut.kind(t) == SurfaceKind::skin;
        for (int i = 0; i < 3; ++i) {
            const Vec3& place = cut.restPosition(cut.triangle(t)[i]);
            const Uv expected =
                cut.kind(t) == SurfaceKind::wall ? Uv(0, 0) : uvAt(place, middle.x() > 0);
            EXPECT_LT((carried[t][i] - expected).norm(), 1e-5) << "triangle " << t;
        }
    }
    EXPECT_GT(newSkin, 20);
}

/// Red grows with x, and the material changes at x = 0 along edges of the box.
TEST(SkinAttributes, ColoursAndMaterialsFollowACut) {
    const SurfaceMesh uncut = test::box(Vec3::Ones(), 4);
    const auto colorAt = [](const Vec3& p) {
        const float red = 0.5F + 0.4F * static_cast<float>(p.x());
        return Eigen::Vector4f(red, 0.25F, 1, 1);
    };
    SkinAttributes skin;
    for (int t = 0; t < uncut.triangleSlots(); ++t) {
        const auto [a, b, c] = restCornersOf(uncut, t);
        skin.colors.push_back({colorAt(a), colorAt(b), colorAt(c)});
        skin.materials.push_back((a + b + c).x() > 0 ? 1 : 0);
    }
    SurfaceMesh cut = uncut;
    cutThrough(cut, Vec3(-0.83, 1.1, 0), Vec3(0.61, -1.2, 0));
    const SkinAttributes carried = carrySkin(uncut, skin, cut);
    EXPECT_TRUE(carried.uvs.empty());
    ASSERT_EQ(static_cast<int>(carried.materials.size()), cut.triangleSlots());
    for (int t = 0; t < cut.triangleSlots(); ++t) {
        if (!cut.alive(t)) {
            continue;
        }
        const auto corners = restCornersOf(cut, t);
        const bool wall = cut.kind(t) == SurfaceKind::wall;
        const int side = (corners[0] + corners[1] + corners[2]).x() > 0 ? 1 : 0;
        EXPECT_EQ(carried.materials[t], wall ? -1 : side);
        for (int i = 0; i < 3 && !wall; ++i) {
            EXPECT_LT((carried.colors[t][i] - colorAt(corners[i])).norm(), 1e-5);
        }
    }
}

}  // namespace
}  // namespace kerf
