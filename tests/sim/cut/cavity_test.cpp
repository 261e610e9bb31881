// Bodies with a cavity: a shell inside another one, which belongs to the same piece.

namespace kerf {
namespace {

const Vec3 kMiddle(0.013, 0.021, 0.034);
const Vec3 kCavity(0.02, -0.01, 0.03);
constexpr double kRadius = 0.5;
constexpr double kHollow = 0.25;

SurfaceMesh hollowBall() {
    return hollow(icosphereSoup(3, kRadius), icosphereSoup(2, kHollow), kCavity);
}

void expectSoundCut(const CutCheck& check) {
    expectSound(check);
    EXPECT_GT(check.cuts, 0);
}

/// Both parts that a plane gives, each as large as the mesh was on its side, within 1e-6 of all.
void expectParts(const SurfaceMesh& before, const SurfaceMesh& after, const Vec3& at,
                 const Vec3& normal) {
    const PieceMap map = findPieces(after);
    ASSERT_EQ(map.pieces.size(), 2u);
    const HalfSpaceVolumes sides = clipVolumes(before, at, normal);
    const double tolerance = 1e-6 * meshVolume(before);
    for (int piece = 0; piece < 2; ++piece) {
        const bool above = meanSide(after, map, piece, at, normal) > 0;
        EXPECT_NEAR(map.pieces[piece].volume, above ? sides.above : sides.below, tolerance);
    }
}

/// Corners plus triangles less edges of the walls of one side: 1 for a disc, 0 for a ring.
int characteristicOfWall(const SurfaceMesh& mesh, int label) {
    std::vector<char> used(mesh.vertexCount(), 0);
    int triangles = 0;
    int inner = 0;
    int border = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t) || mesh.wallLabel(t) != label) {
            continue;
        }
        ++triangles;
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            used[mesh.origin(h)] = 1;
            (mesh.wallLabel(mesh.twin(h) / 3) == label ? inner : border) += 1;
        }
    }
    int vertices = 0;
    for (const char u : used) {
        vertices += u;
    }
    return vertices - (inner / 2 + border) + triangles;
}

TEST(CavityCut, ThroughTheMiddleGivesTwoBowlsWithRingsForWalls) {
    for (const int steps : {1, 60}) {
        const SurfaceMesh before = hollowBall();
        SurfaceMesh mesh = before;
        expectSoundCut(
            runStroke(mesh, exactSettings(),
                      straightStroke(kMiddle, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, steps)));
        expectParts(before, mesh, kMiddle, Vec3::UnitZ());
        EXPECT_EQ(characteristicOfWall(mesh, 0), 0);
        EXPECT_EQ(characteristicOfWall(mesh, 1), 0);
        EXPECT_FALSE(PieceLabels(mesh).hasCavities());
    }
}

/// The hollow ball, cut straight through at that height over its middle.
SurfaceMesh cutAt(double height) {
    const Vec3 at = kMiddle + Vec3(0, 0, height);
    const SurfaceMesh before = hollowBall();
    SurfaceMesh mesh = before;
    expectSoundCut(runStroke(mesh, exactSettings(),
                             straightStroke(at, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, 60)));
    expectParts(before, mesh, at, Vec3::UnitZ());
    return mesh;
}

TEST(CavityCut, CapThatComesOffLeavesTheCavityToTheRest) {
    const SurfaceMesh mesh = cutAt(0.33);
    EXPECT_EQ(characteristicOfWall(mesh, 0), 1);
    EXPECT_TRUE(PieceLabels(mesh).hasCavities());
}

TEST(CavityCut, CapOfTheOtherSideToo) {
    cutAt(-0.33);  // the shell that keeps the lowest vertex is now the one that comes off
}

TEST(CavityCut, TwiceCrosswiseGivesFourQuarters) {
    SurfaceMesh mesh = hollowBall();
    const double volume = meshVolume(mesh);
    Cutter cutter(mesh, exactSettings());
    expectSoundCut(runStroke(cutter, mesh,
                             straightStroke(kMiddle, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, 60)));
    expectSoundCut(runStroke(cutter, mesh,
                             straightStroke(kMiddle, Vec3::UnitZ(), -Vec3::UnitY(), 3, 2.4, 60)));
    const PieceMap map = findPieces(mesh);
    EXPECT_EQ(map.pieces.size(), 4u);
    double sum = 0;
    for (const Piece& piece : map.pieces) {
        EXPECT_GT(piece.volume, 0.1 * volume);
        sum += piece.volume;
    }
    EXPECT_NEAR(sum, volume, 1e-6 * volume);
}

TEST(CavityCut, SlitFromOutsideIntoTheCavityOpensItAndKeepsOnePiece) {
    SurfaceMesh mesh = hollowBall();
    Stroke stroke;
    for (int i = 0; i <= 40; ++i) {
        const double x = -0.7 + 0.035 * i;
        stroke.push_back({{x, 1.5, 0.011}, {x, 0.05, 0.013}});
    }
    expectSoundCut(runStroke(mesh, exactSettings(), stroke));
    EXPECT_EQ(findPieces(mesh).pieces.size(), 1u);
    EXPECT_FALSE(PieceLabels(mesh).hasCavities());
}

TEST(CavityCut, SlitThatBeginsInTheCavityKeepsIt) {
    // The blade moves from the hollow into the material and never reaches the skin.
    SurfaceMesh mesh = hollowBall();
    const double volume = meshVolume(mesh);
    Stroke stroke;
    for (int i = 0; i <= 20; ++i) {
        const double x = 0.02 + 0.018 * i;
        stroke.push_back({{x, -0.08, 0.031}, {x, 0.09, 0.033}});
    }
    expectSoundCut(runStroke(mesh, exactSettings(), stroke));
    EXPECT_EQ(findPieces(mesh).pieces.size(), 1u);
    EXPECT_NEAR(meshVolume(mesh), volume, 1e-9);
    EXPECT_TRUE(PieceLabels(mesh).hasCavities());
}

TEST(CavityCut, AskewThroughBothShells) {
    for (int i = 0; i < 8; ++i) {
        SCOPED_TRACE(i);
        const Vec3 normal =
            Vec3(std::sin(1.3 * i), std::cos(2.1 * i), std::sin(0.7 * i + 1)).normalized();
        const Vec3 along = normal.unitOrthogonal();
        const Vec3 at = kMiddle + (0.4 - 0.1 * i) * normal;
        const SurfaceMesh before = hollowBall();
        SurfaceMesh mesh = before;
        expectSoundCut(runStroke(mesh, exactSettings(),
                                 straightStroke(at, along, normal.cross(along), 3, 2.4, 50)));
        expectParts(before, mesh, at, normal);
    }
}

TEST(CavityCut, SeveralCavitiesEachGoWithTheirPart) {
    TriangleSoup soup = icosphereSoup(3, kRadius);
    for (const double z : {-0.25, 0.05, 0.3}) {
        soup = joined(soup, turned(icosphereSoup(2, 0.11)), Vec3(0.03, 0, z));
    }
    const SurfaceMesh before = meshOf(soup);
    SurfaceMesh mesh = before;
    expectSoundCut(runStroke(mesh, exactSettings(),
                             straightStroke(kMiddle, Vec3::UnitX(), -Vec3::UnitY(), 3, 2.4, 60)));
    expectParts(before, mesh, kMiddle, Vec3::UnitZ());
}

}  // namespace
}  // namespace kerf
