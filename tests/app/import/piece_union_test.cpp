#include "app/import/piece_union.h"

#include "sim/mesh/surface_mesh.h"
#include "sim/repair/crossings.h"

namespace kerf {
namespace {

MeshReport reportOf(const TriangleSoup& soup) {
    MeshReport report = inspectTriangles(soup);
    countCrossings(soup, report);
    return report;
}

/// The triangles whose first corner lies beyond `x`.
std::vector<Corners> trianglesBeyond(const TriangleSoup& soup, double x) {
    std::vector<Corners> found;
    for (const Triangle& t : soup.triangles) {
        const Corners corners{soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
        if (corners[0].x() > x) {
            found.push_back(corners);
        }
    }
    return found;
}

TEST(PieceUnion, OfTwoBoxesIsTheBoundaryOfBoth) {
    TriangleSoup soup = joined(boxSoup(), boxSoup(), Vec3(0.5, 0.25, 0.125));
    const app::PieceUnion became = app::uniteCrossingPieces(soup);
    EXPECT_THAT(became.done, ElementsAre("united 2 pieces that crossed"));
    EXPECT_THAT(became.left, IsEmpty());
    const MeshReport report = reportOf(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.pieces, 1);
    EXPECT_EQ(report.crossingTriangles, 0);
    EXPECT_NEAR(report.volume, 2 - 0.5 * 0.75 * 0.875, 1e-12);
}

/// All pieces become one, of this volume.
void expectUnited(TriangleSoup soup, const std::string& what, double volume) {
    EXPECT_THAT(app::uniteCrossingPieces(soup).done, ElementsAre(what));
    const MeshReport report = reportOf(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.pieces, 1);
    EXPECT_EQ(report.crossingTriangles, 0);
    EXPECT_NEAR(report.volume, volume, 1e-12);
}

TEST(PieceUnion, OfBoxesThatMeetOnEdgesAndDiagonalsAlone) {
    expectUnited(joined(boxSoup(), boxSoup(), Vec3::Constant(0.5)), "united 2 pieces that crossed",
                 2 - 0.125);
}

TEST(PieceUnion, OfARowOfBoxesWithSidesInCommonPlanes) {
    TriangleSoup soup = boxSoup();
    for (int i = 1; i < 8; ++i) {
        soup = joined(soup, boxSoup(), Vec3(0.5 * i, 0, 0));
    }
    expectUnited(soup, "united 8 pieces that crossed", 4.5);
}

TEST(PieceUnion, OfRandomSpheresInAChainHasTheVolumeThatSamplesShow) {
    constexpr unsigned kSeed = 20261124;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> anywhere(-0.4, 0.4);
    TriangleSoup soup = icosphereSoup(2, 0.5);
    std::vector<Vec3> middles{Vec3::Zero()};
    for (int i = 0; i < 4; ++i) {
        middles.emplace_back(anywhere(random), anywhere(random), anywhere(random));
        soup = joined(soup, icosphereSoup(2, 0.5), middles.back());
    }
    const app::PieceUnion became = app::uniteCrossingPieces(soup);
    EXPECT_THAT(became.left, IsEmpty()) << "seed " << kSeed;
    const MeshReport report = reportOf(soup);
    EXPECT_TRUE(report.cuttable) << report.problem << ", seed " << kSeed;
    EXPECT_EQ(report.pieces, 1);
    EXPECT_EQ(report.crossingTriangles, 0) << "seed " << kSeed;

    constexpr int kSamples = 200'000;
    std::uniform_real_distribution<double> inBox(-1, 1);
    int inside = 0;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 p(inBox(random), inBox(random), inBox(random));
        inside += std::ranges::any_of(middles, [&](const Vec3& m) { return (p - m).norm() < 0.5; });
    }
    // Polyhedra of 320 triangles lie within their spheres, by 4 % of the volume.
    EXPECT_NEAR(report.volume, 8.0 * inside / kSamples, 0.06);
}

TEST(PieceUnion, LeavesWhatCrossesNothingBitForBit) {
    TriangleSoup soup = joined(boxSoup(), boxSoup(), Vec3(0.5, 0.25, 0.125));
    soup = joined(soup, icosphereSoup(2), Vec3(5.1, 0.3, 0));
    const std::vector<Corners> ball = trianglesBeyond(soup, 3);
    ASSERT_EQ(ball.size(), 320u);
    app::uniteCrossingPieces(soup);
    EXPECT_EQ(trianglesBeyond(soup, 3), ball);
    EXPECT_EQ(reportOf(soup).pieces, 2);

    const TriangleSoup before = soup;
    EXPECT_THAT(app::uniteCrossingPieces(soup).done, IsEmpty());
    EXPECT_EQ(soup.positions, before.positions);
    EXPECT_EQ(soup.triangles, before.triangles);
}

TEST(PieceUnion, KeepsACavity) {
    TriangleSoup soup = joined(boxSoup(), turned(boxSoup(Vec3::Constant(0.25))), Vec3(-0.25, 0, 0));
    soup = joined(soup, boxSoup(), Vec3(0.5, 0.25, 0.125));
    ASSERT_EQ(reportOf(soup).cavities, 1);
    EXPECT_THAT(app::uniteCrossingPieces(soup).left, IsEmpty());
    const MeshReport report = reportOf(soup);
    EXPECT_EQ(report.cavities, 1);
    EXPECT_EQ(report.pieces, 1);
    EXPECT_NEAR(report.volume, 2 - 0.5 * 0.75 * 0.875 - 0.015625, 1e-12);
}

TEST(PieceUnion, WhatLiesInTwoPiecesThatCrossIsFilled) {
    for (const bool outward : {true, false}) {
        TriangleSoup both = joined(boxSoup(), boxSoup(), Vec3(0.5, 0.25, 0.125));
        const TriangleSoup small = boxSoup(Vec3::Constant(0.1));
        both = joined(both, outward ? small : turned(small), Vec3(0.25, 0.12, 0.06));
        turnOutward(both);
        expectUnited(both, "united 2 pieces that crossed", 2 - 0.5 * 0.75 * 0.875);
    }
}

TEST(PieceUnion, MaterialsAndTextureCoordinatesStayWhereTheyAre) {
    TriangleSoup soup = joined(boxSoup(), boxSoup(), Vec3(0.5, 0.25, 0.125));
    const std::size_t half = soup.triangles.size() / 2;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        CornerUvs uvs;
        for (int i = 0; i < 3; ++i) {
            const Vec3& p = soup.positions[soup.triangles[t][i]];
            uvs[i] = Eigen::Vector2d(p.x() + 3 * p.z(), p.y() - p.z()).cast<float>();
        }
        soup.skin.uvs.push_back(uvs);
        soup.skin.materials.push_back(t < half ? 0 : 1);
    }
    ASSERT_THAT(app::uniteCrossingPieces(soup).left, IsEmpty());
    ASSERT_EQ(soup.skin.uvs.size(), soup.triangles.size());
    ASSERT_EQ(soup.skin.materials.size(), soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        Vec3 middle = Vec3::Zero();
        for (int i = 0; i < 3; ++i) {
            const Vec3& p = soup.positions[soup.triangles[t][i]];
            middle += p / 3;
            const Eigen::Vector2d uv(p.x() + 3 * p.z(), p.y() - p.z());
            EXPECT_LT((soup.skin.uvs[t][i].cast<double>() - uv).norm(), 1e-5);
        }
        const bool onFirst = middle.cwiseAbs().maxCoeff() < 0.5 + 1e-9;
        EXPECT_EQ(soup.skin.materials[t], onFirst ? 0 : 1);
    }
}

TEST(PieceUnion, WhatCannotBeUnitedIsLeftWithTheReason) {
    const auto expectLeft = [](TriangleSoup soup, const std::string& reason) {
        const TriangleSoup before = soup;
        const app::PieceUnion became = app::uniteCrossingPieces(soup);
        EXPECT_THAT(became.done, IsEmpty());
        EXPECT_THAT(became.left, ElementsAre(HasSubstr(reason)));
        EXPECT_EQ(soup.positions, before.positions);
        EXPECT_EQ(soup.triangles, before.triangles);
    };
    // Two bars through a box: they leave it side by side and share an edge there.
    TriangleSoup bars = joined(boxSoup(), boxSoup(Vec3(0.5, 0.5, 2)), Vec3(0.25, 0.25, 0));
    bars = joined(bars, boxSoup(Vec3(0.5, 0.5, 2)), Vec3(-0.25, -0.25, 0));
    expectLeft(bars, "touch in a line or a point");
    TriangleSoup crossed = icosphereSoup(2);
    crossed.positions[0] = -1.5 * crossed.positions[0];
    crossed = joined(crossed, boxSoup(), Vec3(0.4, 0, 0));
    ASSERT_GT(reportOf(crossed).crossingTriangles, 0);
    expectLeft(crossed, "1 piece passes through itself");
}

TEST(PieceUnion, ARepairSaysWhatItLeavesOfAPieceThatPassesThroughItself) {
    TriangleSoup soup = icosphereSoup(2);
    soup.positions[0] = -1.5 * soup.positions[0];
    const TemporaryFolder folder;
    writeText(folder / "crossed.obj", objText(soup));
    app::ReadOptions options;
    options.repair = true;
    const app::ModelMesh model = app::readModel(folder / "crossed.obj", options);
    EXPECT_THAT(model.remarks, ElementsAre(HasSubstr("1 piece passes through itself")));
}

TEST(PieceUnion, DoesNotDependOnTheOrderOfPieces) {
    // The first two touch in a line that the third one covers.
    const std::vector<TriangleSoup> boxes{boxSoup(), boxSoup(), boxSoup(Vec3(1, 1, 2))};
    const std::vector<Vec3> places{{0, 0, 0}, {1, 1, 0}, {0.5, 0.5, 0}};
    std::vector<int> order{0, 1, 2};
    do {
        TriangleSoup soup;
        for (const int i : order) {
            soup = joined(soup, boxes[i], places[i]);
        }
        expectUnited(soup, "united 3 pieces that crossed", 3.5);
    } while (std::next_permutation(order.begin(), order.end()));
}

/// Boxes with corners on whole numbers.
struct GridBoxes {
    std::vector<std::array<Eigen::Vector3i, 2>> boxes;

    TriangleSoup soup() const {
        TriangleSoup all;
        for (const auto& [low, high] : boxes) {
            TriangleSoup box = boxSoup((high - low).cast<double>());
            all = joined(all, box, (low + high).cast<double>() / 2);
        }
        return all;
    }
    /// By counting the cells that lie in any of them, of a grid of 7.
    int volume() const {
        int cells = 0;
        for (int cell = 0; cell < 7 * 7 * 7; ++cell) {
            const Eigen::Vector3i at(cell % 7, cell / 7 % 7, cell / 49);
            cells += std::ranges::any_of(boxes, [&](const auto& box) {
                return (box[0].array() <= at.array()).all() && (at.array() < box[1].array()).all();
            });
        }
        return cells;
    }
};

GridBoxes randomBoxes(std::mt19937& random) {
    const auto upTo = [&](unsigned count) { return static_cast<int>(random() % count); };
    GridBoxes all;
    const int count = 2 + upTo(3);
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3i low(upTo(4), upTo(4), upTo(4));
        all.boxes.push_back({low, low + Eigen::Vector3i(1 + upTo(3), 1 + upTo(3), 1 + upTo(3))});
    }
    return all;
}

/// Solids with faces, edges and corners in common, and one within another as if that were none.
TEST(PieceUnion, ARepairOfBoxesOnAGridHasTheVolumeOfTheirCells) {
    constexpr unsigned kGridSeed = 20261126;
    std::mt19937 random(kGridSeed);
    int runs = 0;
    for (int run = 0; run < 40; ++run) {
        SCOPED_TRACE(testing::Message() << "seed " << kGridSeed << ", run " << run);
        const GridBoxes boxes = randomBoxes(random);
        const TriangleSoup soup = boxes.soup();
        // A box within another one that touches none of its sides bounds a cavity.
        if (inspectTriangles(weldExactly(soup)).outwardCavities > 0) {
            continue;
        }
        ++runs;
        app::ImportOrder order{{.repair = true}};
        order.toFile = true;
        order.findCrossingsUpTo = 1'000'000;
        const app::ImportAnswer mended = app::answerFor("boxes.obj", {soup}, order);
        EXPECT_NEAR(mended.report.volume, boxes.volume(), 2e-3 * boxes.volume());
        EXPECT_THAT(mended.report.left, IsEmpty());
        EXPECT_EQ(mended.report.crossingTriangles, 0);
        EXPECT_TRUE(mended.report.cuttable) << mended.reason;
    }
    EXPECT_GT(runs, 30);
}

}  // namespace
}  // namespace kerf
