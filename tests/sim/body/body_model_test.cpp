#include "sim/body/body_model.h"

#include "sim/body/ispc_builder.h"
#include "tests/sim/body/hand_cut.h"
#include "tests/sim/body/ispc_bits.h"

namespace kerf {
namespace {

double totalMass(const BodyModel& model) {
    const std::vector<double> masses = unitMasses(model);
    return std::accumulate(masses.begin(), masses.end(), 0.0);
}

/// Everything that must hold in any model.
void expectConsistent(const BodyModel& model, const SurfaceMesh& mesh) {
    ASSERT_EQ(model.triangles.size(), static_cast<std::size_t>(mesh.aliveTriangles()));
    EXPECT_EQ(2 * model.edges.size(), 3 * model.triangles.size());
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const Triangle& corners = mesh.triangle(model.meshTriangle[i]);
        EXPECT_EQ(model.triangles[i][0], static_cast<std::uint32_t>(corners[0]));
        EXPECT_EQ(model.triangles[i][3] & 1u,
                  static_cast<std::uint32_t>(mesh.kind(model.meshTriangle[i])));
        EXPECT_EQ(model.triangles[i][3] >> 8,
                  static_cast<std::uint32_t>(model.pieceOfVertex[corners[0]]));
    }
    for (std::size_t i = 0; i < model.ispcs.size(); ++i) {
        const Triangle& corners = mesh.triangle(model.ispcMeshTriangle[i]);
        EXPECT_EQ(model.ispcs[i].t0, static_cast<std::uint32_t>(corners[0]));
        EXPECT_EQ(model.pieceOfVertex[model.ispcs[i].vertex],
                  model.pieceOfVertex[model.ispcs[i].t0]);
    }
}

TEST(BodyModel, MassIsDensityTimesVolume) {
    for (const SurfaceMesh& mesh : {icosphere(1), bentTube(), box()}) {
        const BodyModel model = buildBodyModel(mesh);
        expectConsistent(model, mesh);
        EXPECT_NEAR(totalMass(model), meshRestVolume(mesh), 1e-6 * meshRestVolume(mesh));
        EXPECT_NEAR(model.uncutRestVolume, meshRestVolume(mesh), 1e-12);
        EXPECT_NEAR(model.members[0].thickness * model.pieces[0].restArea, model.uncutRestVolume,
                    1e-12);
    }
}

TEST(BodyModel, NoVertexIsMuchLighterThanTheMean) {
    SurfaceMesh mesh = icosphere(2);
    // Shrink the fan of one vertex to almost nothing.
    const Vec3 center = mesh.restPosition(20);
    mesh.forEachOutgoing(20, [&](int h) {
        const Vec3 p = mesh.restPosition(mesh.target(h));
        mesh.setRestPosition(mesh.target(h), center + 1e-4 * (p - center));
    });
    const BodyModel model = buildBodyModel(mesh);
    const double mean = totalMass(model) / mesh.vertexCount();
    for (const double mass : unitMasses(model)) {
        EXPECT_GT(mass, 0.045 * mean);
    }
}

TEST(BodyModel, EveryVertexOfAClosedShapeGetsAnIspc) {
    for (const SurfaceMesh& mesh : {icosphere(0), icosphere(1), cubeSphere(8), bentTube(64, 40),
                                    box(Vec3(1, 2, 3), 4), torus(), icosphere(4)}) {
        const BodyModel model = buildBodyModel(mesh);
        EXPECT_EQ(model.ispcs.size(), static_cast<std::size_t>(mesh.vertexCount()));
    }
}

TEST(BodyModel, EveryVertexOfTheBuiltinModelsGetsAnIspc) {
    for (const char* name : {"sphere20", "sphere80", "sphere768", "banana", "octopus"}) {
        const SurfaceMesh mesh = builtin(name);
        const BodyModel model = buildBodyModel(mesh);
        expectConsistent(model, mesh);
        EXPECT_EQ(model.ispcs.size(), static_cast<std::size_t>(mesh.vertexCount())) << name;
        EXPECT_EQ(model.bends.size(), model.edges.size()) << name;
    }
}

TEST(BodyModel, IspcsOfASphereAreItsDiameters) {
    const double radius = 0.5;
    const BodyModel exact = buildBodyModel(icosphere(0, radius));
    for (const auto& ispc : exact.ispcs) {
        EXPECT_NEAR(ispc.rest_length, 2 * radius, 1e-6);
    }
    const SurfaceMesh mesh = icosphere(3, radius);
    for (const auto& ispc : buildBodyModel(mesh).ispcs) {
        EXPECT_NEAR(ispc.rest_length, 2 * radius, 0.01 * radius);
        const double chord =
            (mesh.restPosition(static_cast<int>(ispc.vertex)) - restEnd(mesh, ispc)).norm();
        EXPECT_NEAR(ispc.rest_length, chord, 1e-6);
    }
}

TEST(BodyModel, IncidenceListsEveryElementOfAVertexInOrder) {
    const BodyModel model = buildBodyModel(icosphere(1));
    const Incidence& incidence = model.incidences[shared::kIspc];
    std::size_t entries = 0;
    for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
        for (std::uint32_t i = incidence.ranges[v].first; i < incidence.ranges[v].end; ++i) {
            const std::uint32_t entry = incidence.entries[i];
            EXPECT_EQ(verticesOf(model.ispcs[entry / 4])[entry % 4], v);
            EXPECT_TRUE(i == incidence.ranges[v].first || incidence.entries[i - 1] < entry);
        }
        EXPECT_EQ(valence(model.incidences[shared::kStretch], v),
                  valence(model.triangleIncidence, v));
        entries += valence(incidence, v);
    }
    EXPECT_EQ(entries, 4 * model.ispcs.size());
}

/// A box cut in two along y = 0, with the models before and after.
class CutBox : public testing::Test {
  protected:
    SurfaceMesh mesh = box(Vec3::Ones(), 8);
    BodyUpdater updater{mesh};
    BodyModel before = updater.model();
    CutDelta delta = HandCut(mesh).delta();
    BodyChange change = updater.update(delta);
    BodyModel after = updater.model();
};

TEST_F(CutBox, HasTwoPiecesThatKeepMassThicknessAndScale) {
    ASSERT_EQ(checkClosedManifold(mesh), "");
    expectConsistent(after, mesh);
    ASSERT_EQ(after.pieces.size(), 2u);
    for (const PieceModel& piece : after.pieces) {
        EXPECT_NEAR(piece.restVolume, 0.5, 1e-12);
        EXPECT_NEAR(piece.restArea, 4, 1e-12);
        EXPECT_TRUE(piece.holdsVolume);
    }
    EXPECT_NEAR(totalMass(after), totalMass(before), 1e-6);
    EXPECT_EQ(after.members[0].thickness, before.members[0].thickness);
    EXPECT_EQ(after.edgeLength, before.edgeLength);
    EXPECT_EQ(after.diagonal, before.diagonal);
    EXPECT_EQ(after.uncutRestVolume, before.uncutRestVolume);
}

TEST_F(CutBox, KeepsUntouchedIspcsBitForBit) {
    int kept = 0;
    for (const auto& ispc : before.ispcs) {
        const Vec3 p = mesh.restPosition(static_cast<int>(ispc.vertex));
        const double endHeight = restEnd(mesh, ispc).y();
        // Rays that stay on one side of the cut and off the triangles beside it.
        if (std::abs(p.y()) < 0.2 || std::abs(endHeight) < 0.2 || p.y() * endHeight < 0) {
            continue;
        }
        const auto same = std::ranges::find_if(
            after.ispcs, [&](const auto& other) { return sameBits(other, ispc); });
        EXPECT_NE(same, after.ispcs.end()) << ispc.vertex;
        ++kept;
    }
    EXPECT_GT(kept, 100);
}

TEST_F(CutBox, NoIspcCrossesTheWallsAndEveryVertexStillHasOne) {
    int shortened = 0;
    for (const auto& ispc : after.ispcs) {
        const Vec3 p = mesh.restPosition(static_cast<int>(ispc.vertex));
        EXPECT_GE(p.y() * restEnd(mesh, ispc).y(), -1e-9) << ispc.vertex;
        shortened += p.y() > 0.49 && std::abs(ispc.rest_length - 0.5) < 1e-5;
    }
    EXPECT_EQ(shortened, 49) << "rays from the top end on the wall";
    EXPECT_EQ(after.ispcs.size(), static_cast<std::size_t>(mesh.vertexCount()));
}

TEST_F(CutBox, ADeltaThatTouchesNothingKeepsAllIspcs) {
    CutDelta nothing;
    nothing.firstNewVertex = mesh.vertexCount();
    EXPECT_TRUE(updater.update(nothing).vertices.empty());
    const BodyModel& again = updater.model();
    ASSERT_EQ(again.ispcs.size(), after.ispcs.size());
    for (std::size_t i = 0; i < again.ispcs.size(); ++i) {
        EXPECT_TRUE(sameBits(again.ispcs[i], after.ispcs[i])) << i;
    }
}

TEST(BodyModel, ASlitFrontGetsNoIspc) {
    // Two walls of a slit that meet in vertex 0: a flat pocket, folded onto itself.
    SurfaceMesh mesh = box(Vec3::Ones(), 2);
    const int front = 0;
    int flip = 0;
    mesh.forEachOutgoing(front, [&](int h) {
        const Vec3 side = (flip++ % 2 == 0 ? 1.0 : -1.0) * Vec3(0.2, 0, 0);
        mesh.setRestPosition(mesh.target(h), mesh.restPosition(front) + side + Vec3(0, 0, 0.1));
    });
    const BodyModel model = buildBodyModel(mesh);
    for (const auto& ispc : model.ispcs) {
        EXPECT_NE(ispc.vertex, static_cast<std::uint32_t>(front));
    }
}

TEST(BodyModel, DebrisHoldsNoVolume) {
    const TriangleSoup chip = boxSoup(Vec3::Constant(0.01));
    const SurfaceMesh mesh = meshOf(joined(icosphereSoup(2), chip, Vec3(2, 0, 0)));
    const BodyModel model = buildBodyModel(mesh);
    ASSERT_EQ(model.pieces.size(), 2u);
    EXPECT_TRUE(model.pieces[0].holdsVolume);
    EXPECT_FALSE(model.pieces[1].holdsVolume);
}

}  // namespace
}  // namespace kerf
