namespace kerf {
namespace {

// One large triangle abc on top, its corners joined to a vertex d below. The blade turns about its
// handle high above, so that the strip of a step meets the top in one segment; its tip is 0.2 below
// the top. Its path there leads in through the edge ab and out through bc:
//
//          c
//         / \      .
//        /   -->
//       a-->--b
const Vec3 kA(-1, 0, 1), kB(1, 0, 1), kC(0, 0, -1), kD(0, -2, 0.2);
const Vec3 kHandle(-0.15, 3, 0.9);

SurfaceMesh wedge() {
    return SurfaceMesh::fromTriangles({kA, kB, kC, kD},
                                      {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}});
}

CutSettings wedgeSettings() {
    CutSettings settings = exactSettings();
    settings.wallEdgeLength = 0.3;
    settings.gate = 0.1;
    return settings;
}

/// The blade that meets the plane of the top at `p`.
Blade bladeThrough(const Vec3& p) {
    return {kHandle, kHandle + (p - kHandle) * (3.2 / 3.0)};
}

int countOf(const CutResult& result, SubdivisionPattern pattern) {
    return result.statistics.patterns[static_cast<int>(pattern)];
}

int addedSkin(const SurfaceMesh& mesh, const CutResult& result) {
    int count = 0;
    for (const int t : result.delta.addedTriangles) {
        count += mesh.kind(t) == SurfaceKind::skin;
    }
    return count;
}

/// Copies of the vertex at `p`.
int copiesAt(const SurfaceMesh& mesh, const Vec3& p) {
    int copies = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        copies += mesh.outgoing(v) >= 0 && (mesh.position(v) - p).norm() < 1e-5;
    }
    return copies;
}

class Patterns : public ::testing::Test {
  protected:
    SurfaceMesh mesh = wedge();
    Cutter cutter{mesh, wedgeSettings()};
    const Vec3 before{-0.3, 0, 1.4};
    const Vec3 entry{-0.2, 0, 1};  // on ab
    const Vec3 inside{-0.1, 0, 0.6};
    const Vec3 further{0.05, 0, 0.4};
    const Vec3 beyond{1.2, 0, 0.2};

    /// From outside to `inside`.
    CutResult enter() {
        cutter.begin(bladeThrough(before));
        return cutter.advance(bladeThrough(inside));
    }

    void TearDown() override {
        EXPECT_EQ(checkClosedManifold(mesh), "");
        EXPECT_EQ(checkMirroredWalls(mesh), "");
        EXPECT_NEAR(meshVolume(mesh), meshVolume(wedge()), 1e-12);
    }
};

TEST_F(Patterns, EdgeAndFaceGiveFour) {
    const CutResult result = enter();
    ASSERT_EQ(result.outcome, CutOutcome::cut);
    // The top triangle, and the side below ab, which the tip's path pierces.
    EXPECT_EQ(countOf(result, SubdivisionPattern::oneToFour), 2);
    EXPECT_EQ(result.statistics.touchedTriangles, 2);
    EXPECT_EQ(addedSkin(mesh, result), 2 * 4);
    EXPECT_EQ(result.statistics.splitVertices, 1);
    EXPECT_EQ(copiesAt(mesh, entry), 2) << "the mouth is open";
    EXPECT_EQ(copiesAt(mesh, inside), 1) << "the front is one vertex";
}

TEST_F(Patterns, TwoEdgesGiveThree) {
    cutter.begin(bladeThrough(before));
    const CutResult result = cutter.advance(bladeThrough(beyond));
    ASSERT_EQ(result.outcome, CutOutcome::cut);
    EXPECT_EQ(countOf(result, SubdivisionPattern::oneToThreeA), 1);
    EXPECT_EQ(countOf(result, SubdivisionPattern::oneToFour), 2) << "both sides, at the tip's path";
    EXPECT_EQ(addedSkin(mesh, result), 3 + 2 * 4);
    EXPECT_EQ(result.statistics.splitVertices, 2) << "both mouths are open, the tip path is closed";
}

TEST_F(Patterns, VertexAndEdgeGiveTwo) {
    enter();
    const CutResult result = cutter.advance(bladeThrough(beyond));
    ASSERT_EQ(result.outcome, CutOutcome::cut);
    EXPECT_EQ(countOf(result, SubdivisionPattern::oneToTwo), 1);
    // The side below bc has one edge node and two kinks: the tip's path and the strip's diagonal.
    EXPECT_EQ(countOf(result, SubdivisionPattern::twoSegments), 1);
    EXPECT_EQ(addedSkin(mesh, result), 2 + 6);
    EXPECT_EQ(copiesAt(mesh, inside), 2) << "the old front has opened";
}

TEST_F(Patterns, VertexAndFaceGiveThree) {
    enter();
    const CutResult result = cutter.advance(bladeThrough(further));
    ASSERT_EQ(result.outcome, CutOutcome::cut);
    EXPECT_EQ(countOf(result, SubdivisionPattern::oneToThreeB), 1);
    EXPECT_EQ(otherPatterns(result.statistics.patterns), 0);
    EXPECT_EQ(addedSkin(mesh, result), 3);
    EXPECT_EQ(copiesAt(mesh, inside), 2);
    EXPECT_EQ(copiesAt(mesh, further), 1);
}

TEST_F(Patterns, InnerNodesAreDuplicatedInTheNextStep) {
    enter();
    EXPECT_EQ(copiesAt(mesh, inside), 1);
    cutter.advance(bladeThrough(further));
    EXPECT_EQ(copiesAt(mesh, inside), 2);
    EXPECT_EQ(copiesAt(mesh, further), 1);
    cutter.advance(bladeThrough(beyond));
    EXPECT_EQ(copiesAt(mesh, further), 2);
}

TEST(PatternNames, AreThoseOfThePaper) {
    EXPECT_STREQ(nameOf(SubdivisionPattern::oneToFour), "1-to-4");
    EXPECT_STREQ(nameOf(SubdivisionPattern::oneToThreeA), "1-to-3a");
    EXPECT_STREQ(nameOf(SubdivisionPattern::oneToTwo), "1-to-2");
    EXPECT_STREQ(nameOf(SubdivisionPattern::oneToThreeB), "1-to-3b");
}

TEST(Seeds, EveryArmIsFound) {
    // In one step through both arms of the ring, the curves on them are apart.
    SurfaceMesh ring = torus();
    Cutter cutter(ring, exactSettings());
    const Stroke stroke =
        straightStroke(Vec3(0.003, 0.001, 0.007), Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, 1);
    cutter.begin(stroke[0]);
    const CutResult result = cutter.advance(stroke[1]);
    EXPECT_EQ(result.statistics.seeds, 2);
    EXPECT_EQ(findPieces(ring).pieces.size(), 2);
}

}  // namespace
}  // namespace kerf
