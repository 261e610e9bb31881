#include "sim/mesh/invariants.h"

#include "sim/mesh/skin_attributes.h"

namespace kerf {
namespace {

/// The local check, of every triangle.
std::string checkEverywhere(const SurfaceMesh& mesh) {
    std::vector<int> all(mesh.triangleSlots());
    std::iota(all.begin(), all.end(), 0);
    return checkClosedManifoldAround(mesh, all);
}

class SoundShapes : public ::testing::TestWithParam<SurfaceMesh> {};

TEST_P(SoundShapes, PassEveryCheck) {
    EXPECT_EQ(checkClosedManifold(GetParam()), "");
    EXPECT_EQ(checkEverywhere(GetParam()), "");
}

INSTANTIATE_TEST_SUITE_P(Invariants, SoundShapes,
                         ::testing::Values(icosphere(0), icosphere(2), cubeSphere(8), torus(),
                                           bentTube(), box(Vec3(1, 2, 3), 3)));

TEST(Invariants, TwinMissing) {
    SurfaceMesh mesh = icosphere(0);
    mesh.setTwin(7, -1);
    EXPECT_THAT(checkTwins(mesh), HasSubstr("half-edge 7"));
    EXPECT_NE(checkClosedManifoldAround(mesh, std::vector<int>{2}), "");
    EXPECT_EQ(checkClosedManifoldAround(mesh, std::vector<int>{}), "");
    EXPECT_NE(checkClosedManifold(mesh), "");
}

TEST(Invariants, TwinNotMutual) {
    SurfaceMesh mesh = icosphere(0);
    mesh.setTwin(7, mesh.twin(8));
    EXPECT_THAT(checkTwins(mesh), HasSubstr("whose twin is another"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, TwinWithOtherEndPoints) {
    SurfaceMesh mesh = icosphere(0);
    const int g = mesh.twin(7);
    const int f = mesh.twin(8);
    mesh.setTwin(7, f);
    mesh.setTwin(f, 7);
    mesh.setTwin(8, g);
    mesh.setTwin(g, 8);
    EXPECT_THAT(checkTwins(mesh), HasSubstr("other end points"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, TwinInDeadTriangle) {
    SurfaceMesh mesh = icosphere(0);
    mesh.removeTriangle(3);
    EXPECT_THAT(checkTwins(mesh), HasSubstr("no living twin"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, CornerOutOfRange) {
    SurfaceMesh mesh = icosphere(0);
    mesh.setCorner(4, 1, mesh.vertexCount());
    EXPECT_THAT(checkTwins(mesh), HasSubstr("triangle 4 names vertex 12 of 12"));
    EXPECT_NE(checkUmbrellas(mesh), "");
    EXPECT_NE(checkSimpleComplex(mesh), "");
}

TEST(Invariants, OutgoingHalfEdgeOfAnotherVertex) {
    SurfaceMesh mesh = icosphere(0);
    mesh.setOutgoing(5, mesh.outgoing(6));
    EXPECT_THAT(checkUmbrellas(mesh), HasSubstr("vertex 5"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, OutgoingHalfEdgeOfUnusedVertex) {
    SurfaceMesh mesh = icosphere(0);
    const int v = mesh.addVertex(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
    EXPECT_EQ(checkClosedManifold(mesh), "");
    mesh.setOutgoing(v, 0);
    EXPECT_THAT(checkUmbrellas(mesh), HasSubstr("vertex 12"));
}

/// Two tetrahedra that share vertex 0 and nothing else.
TEST(Invariants, TwoUmbrellasAtOneVertex) {
    const SurfaceMesh mesh = SurfaceMesh::fromTriangles(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
    EXPECT_EQ(checkTwins(mesh), "");
    EXPECT_EQ(checkSimpleComplex(mesh), "");
    EXPECT_THAT(checkUmbrellas(mesh), HasSubstr("vertex 0 holds 3 of its 6"));
    EXPECT_NE(checkEverywhere(mesh), "");
}

TEST(Invariants, UmbrellaThatDoesNotClose) {
    SurfaceMesh mesh = icosphere(0);
    const int v = mesh.origin(7);
    int other = -1;
    mesh.forEachOutgoing(v, [&](int h) { other = h; });
    mesh.setTwin(SurfaceMesh::previous(other), SurfaceMesh::next(other));
    EXPECT_NE(checkUmbrellas(mesh), "");
}

TEST(Invariants, TwoEdgesBetweenTheSameVertices) {
    SurfaceMesh mesh = icosphere(0);
    const int t = 0;
    const Triangle corners = mesh.triangle(t);
    mesh.addTriangle({corners[0], corners[1], corners[2]}, SurfaceKind::skin, -1);
    EXPECT_THAT(checkSimpleComplex(mesh), HasSubstr("two edges run between"));
}

TEST(Invariants, EdgeFromAVertexToItself) {
    SurfaceMesh mesh = icosphere(0);
    mesh.setCorner(2, 1, mesh.triangle(2)[0]);
    EXPECT_THAT(checkSimpleComplex(mesh), HasSubstr("starts and ends at one vertex"));
}

TEST(Invariants, NotFinite) {
    const Vec3 bad(0, std::numeric_limits<double>::quiet_NaN(), 0);
    SurfaceMesh mesh = icosphere(0);
    mesh.setPosition(3, bad);
    EXPECT_THAT(checkFinite(mesh), HasSubstr("vertex 3"));
    EXPECT_NE(checkEverywhere(mesh), "");
    mesh = icosphere(0);
    mesh.setRestPosition(4, bad);
    EXPECT_THAT(checkFinite(mesh), HasSubstr("vertex 4"));
    mesh = icosphere(0);
    mesh.setVelocity(5, Vec3(0, 0, std::numeric_limits<double>::infinity()));
    EXPECT_THAT(checkClosedManifold(mesh), HasSubstr("vertex 5"));
}

TEST(Measures, VolumeOfABox) {
    SurfaceMesh mesh = box(Vec3(1, 2, 3), 2);
    EXPECT_NEAR(meshVolume(mesh), 6, 1e-12);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, 2 * mesh.position(v) + Vec3(5, 6, 7));
    }
    EXPECT_NEAR(meshVolume(mesh), 48, 1e-9);
    EXPECT_NEAR(meshRestVolume(mesh), 6, 1e-12);
    EXPECT_LT((meshBounds(mesh).low - Vec3(4, 4, 4)).norm(), 1e-12);
    EXPECT_LT((meshBounds(mesh).high - Vec3(6, 8, 10)).norm(), 1e-12);
}

TEST(Measures, VolumeOfATorus) {
    const SurfaceMesh mesh = torus(256, 128, 0.35, 0.15);
    const double exact = 2 * std::numbers::pi * std::numbers::pi * 0.35 * 0.15 * 0.15;
    EXPECT_NEAR(meshVolume(mesh), exact, 1e-3 * exact);
}

TEST(Pieces, OrderedByTheirLowestVertex) {
    SurfaceMesh mesh = meshOf(joined(boxSoup(), icosphereSoup(1, 0.5), Vec3(3, 0, 0)));
    const PieceMap map = findPieces(mesh);
    ASSERT_EQ(map.pieces.size(), 2u);
    EXPECT_EQ(map.pieces[0].triangles, 12);
    EXPECT_EQ(map.pieces[0].vertices, 8);
    EXPECT_NEAR(map.pieces[0].volume, 1, 1e-12);
    EXPECT_NEAR(map.pieces[0].restArea, 6, 1e-12);
    EXPECT_EQ(map.pieces[1].triangles, 80);
    EXPECT_EQ(map.pieces[1].vertices, 42);
    EXPECT_EQ(map.ofVertex[0], 0);
    EXPECT_EQ(map.ofVertex[8], 1);
}

TEST(Pieces, DeadTrianglesAndUnusedVerticesBelongToNone) {
    SurfaceMesh mesh = meshOf(joined(boxSoup(), icosphereSoup(0, 0.5), Vec3(3, 0, 0)));
    for (int t = 0; t < 12; ++t) {
        mesh.removeTriangle(t);
    }
    const PieceMap map = findPieces(mesh);
    ASSERT_EQ(map.pieces.size(), 1u);
    EXPECT_EQ(map.pieces[0].triangles, 20);
    EXPECT_EQ(map.ofVertex[0], -1);
    EXPECT_EQ(map.ofVertex[8], 0);
}

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
    const SurfaceMesh mesh = box(Vec3::Ones(), 2);
    const SkinAttributes skin{.uvs = linearUvs(mesh), .colors = {}, .materials = {}};
    EXPECT_EQ(carrySkin(mesh, skin, mesh), skin);
    EXPECT_TRUE(carrySkin(mesh, {}, mesh).empty());
}

TEST(SkinAttributes, NewSkinGetsWhatItsPlaceHasAndWallsGetNone) {
    const SurfaceMesh uncut = box(Vec3::Ones(), 4);
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
    const SurfaceMesh uncut = box(Vec3::Ones(), 4);
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
