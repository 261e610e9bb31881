#include "sim/mesh/triangle.h"

#include "sim/mesh/triangle_soup.h"
#include "sim/mesh/winding.h"

namespace kerf {
namespace {

const Corners kRightAngled{Vec3(1, 1, 1), Vec3(4, 1, 1), Vec3(1, 5, 1)};

TEST(Triangle, NormalSeesItsCornersGoCounterClockwise) {
    const auto& [a, b, c] = kRightAngled;
    EXPECT_EQ(areaNormal(kRightAngled), Vec3(0, 0, 12));
    EXPECT_EQ(unitNormal(a, b, c), Vec3::UnitZ());
    EXPECT_EQ(unitNormal(a, c, b), -Vec3::UnitZ());
    EXPECT_EQ(unitNormal(a, b, a), Vec3::Zero()) << "no area";
}

TEST(Triangle, AreaIsHalfTheLengthOfItsNormal) {
    EXPECT_EQ(triangleArea(kRightAngled), 6);
}

TEST(Triangle, LongestEdgeIsTheHypotenuse) {
    EXPECT_EQ(longestEdgeSquare(kRightAngled), 25);
    EXPECT_EQ(longestEdge(kRightAngled), 5);
}

TEST(Triangle, TetrahedraSumUpToTheVolumeWhereverTheApexLies) {
    const SurfaceMesh mesh = box(Vec3(2, 3, 4));
    for (const Vec3& apex : {Vec3(0, 0, 0), Vec3(5, -1, 2)}) {
        double volume = 0;
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            const auto [a, b, c] = cornersOf(mesh, t);
            volume += tetrahedronVolume(a - apex, b - apex, c - apex);
        }
        EXPECT_NEAR(volume, 24, 1e-12);
    }
}

TEST(Triangle, CornersAreCurrentOrAtRest) {
    SurfaceMesh mesh = box(Vec3::Ones());
    const Corners rest = restCornersOf(mesh, 0);
    EXPECT_EQ(cornersOf(mesh, 0), rest);
    mesh.setPosition(mesh.triangle(0)[1], Vec3(7, 8, 9));
    EXPECT_EQ(cornersOf(mesh, 0)[1], Vec3(7, 8, 9));
    EXPECT_EQ(restCornersOf(mesh, 0), rest);
}

const Corners kRest{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0.5, 1, 0)};

Corners mapped(const Eigen::Matrix3d& map) {
    Corners corners = kRest;
    for (Vec3& corner : corners) {
        corner = map * corner + Vec3(3, -1, 7);
    }
    return corners;
}

TEST(TriangleStrain, IsThatOfTheLargerPrincipalStretch) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const auto stretched = [&](double x, double y) {
        return largestStrain(kRest, mapped(turn * Eigen::Vector3d(x, y, 1).asDiagonal()));
    };
    EXPECT_NEAR(stretched(1, 1), 0, 1e-7);
    EXPECT_NEAR(stretched(1.25, 1), 0.25, 1e-12);
    EXPECT_NEAR(stretched(1.1, 0.6), 0.4, 1e-12) << "by amount";
    EXPECT_NEAR(stretched(1, 0), 1, 1e-7) << "flat";
}

TEST(TriangleStrain, OfAShearIsThatOfItsStretch) {
    Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
    shear(0, 1) = 1;
    const double golden = (1 + std::sqrt(5.0)) / 2;
    EXPECT_NEAR(largestStrain(kRest, mapped(shear)), golden - 1, 1e-12);
}

TEST(TriangleStrain, IsNoneWithoutAreaAtRest) {
    EXPECT_EQ(largestStrain({Vec3::Zero(), Vec3::UnitX(), 2 * Vec3::UnitX()}, kRest), 0);
}

TEST(TriangleQuality, ANeedleIsLowerThanATenthOfItsLongestEdge) {
    EXPECT_FALSE(isNeedle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.11, 0)}));
    EXPECT_TRUE(isNeedle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.09, 0)}));
    EXPECT_TRUE(isNeedle({Vec3(0, 0, 0), Vec3(1000, 0, 0), Vec3(1, 90, 0)}));
    EXPECT_FALSE(isNeedle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, 0)})) << "has no area";
}

TEST(TriangleQuality, FiguresAreThoseOfTheBox) {
    const TriangleFigures box = figuresOf(boxSoup(Vec3(1, 20, 1)));
    EXPECT_EQ(box.triangles, 12);
    EXPECT_EQ(box.needles, 8);
    EXPECT_NEAR(box.area, 82, 1e-9);
    EXPECT_NEAR(box.shortestEdge, 1, 1e-12);
    EXPECT_NEAR(box.longestEdge, std::sqrt(401), 1e-12);
    EXPECT_EQ(figuresOf({}).meanEdge(), 0);
}

TEST(TriangleQuality, EvenEdgesAreTheMeanOrAtMostFourTimesTheTriangles) {
    const TriangleFigures ball = figuresOf(icosphereSoup(3));
    EXPECT_NEAR(evenEdge(ball), ball.meanEdge(), 0.02 * ball.meanEdge());
    EXPECT_NEAR(trianglesOf(ball, ball.meanEdge()), ball.triangles, 0.05 * ball.triangles);
    const TriangleFigures mixed =
        figuresOf(joined(icosphereSoup(4, 0.01), boxSoup(Vec3::Constant(10)), Vec3::Zero()));
    EXPECT_GT(evenEdge(mixed), 2 * mixed.meanEdge());
    EXPECT_NEAR(trianglesOf(mixed, evenEdge(mixed)), 4.0 * mixed.triangles, 1);
    const TriangleFigures needles = figuresOf(boxSoup(Vec3(1, 20, 1)));
    EXPECT_LT(evenEdge(needles), 0.5 * needles.meanEdge());
}

TEST(TriangleQuality, OfACoarseSkinShorterEdgesAreProposed) {
    const TriangleFigures cube = figuresOf(boxSoup());
    const double diagonal = std::sqrt(3);
    EXPECT_TRUE(isCoarse(cube, diagonal));
    EXPECT_NEAR(proposedEdge(cube, diagonal), diagonal / 25, 1e-12);
    const TriangleFigures fine = figuresOf(boxSoup(Vec3::Ones(), 12));
    EXPECT_FALSE(isCoarse(fine, diagonal));
    EXPECT_EQ(proposedEdge(fine, diagonal), evenEdge(fine));
    EXPECT_FALSE(isCoarse(figuresOf({}), 0));
    EXPECT_FALSE(isCoarse(figuresOf(builtinSoup("sphere768")), diagonal));
    const TriangleFigures uneven =
        figuresOf(joined(icosphereSoup(4, 0.1), boxSoup(Vec3::Ones()), Vec3(1, 0, 0)));
    EXPECT_TRUE(isCoarse(uneven, 2.2));
    EXPECT_LE(proposedEdge(uneven, 2.2), 2.2 / 25);
}

TEST(ShapeFigures, OfTwoSurfacesAreThoseOfAllTriangles) {
    const Corners even{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, std::sqrt(0.75), 0)};
    const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0.01, 0)};
    ShapeFigures all, first, second;
    for (const Corners& corners : {even, flat}) {
        all.add(corners);
    }
    first.add(even);
    second.add(flat);
    for (ShapeFigures sum : {first, second}) {
        sum.add(sum.slivers > 0 ? first : second);
        EXPECT_EQ(sum.triangles, 2);
        EXPECT_EQ(sum.slivers, 1);
        EXPECT_EQ(sum.bareSlivers, 0);
        EXPECT_EQ(sum.worstAngle, all.worstAngle);
        EXPECT_NEAR(sum.angleSum, all.angleSum, 1e-9);
    }
    EXPECT_NEAR(first.worstAngle, 60, 1e-9);
    EXPECT_NEAR(second.worstAngle, 180 / 3.14159265 * std::atan(0.02), 1e-6);
}

constexpr unsigned kSoupSeed = 20261126;

TEST(RoundToFloats, LeavesNoDoubleHoweverManyThereAre) {
    std::mt19937 random(kSoupSeed);
    std::uniform_real_distribution<double> any(1, 3);
    for (int count = 1; count < 40; ++count) {
        TriangleSoup soup;
        for (int i = 0; i < count; ++i) {
            soup.positions.emplace_back(any(random), any(random), any(random));
            soup.triangles.push_back({i, (i + 1) % count, (i + 2) % count});
        }
        roundToFloats(soup);
        for (const Vec3& p : soup.positions) {
            for (const double x : p) {
                const volatile float rounded = static_cast<float>(x);
                EXPECT_EQ(x, rounded) << "seed " << kSoupSeed << ", of " << count;
            }
        }
    }
}

TEST(RoundToFloats, JoinsWhatIsOnePlaceThen) {
    TriangleSoup soup{{{1, 0, 0}, {1 + 1e-12, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 3}, {1, 3, 2}}};
    roundToFloats(soup);
    EXPECT_EQ(soup.positions.size(), 3u);
}

/// Each triangle with corners of its own, as in an STL.
TriangleSoup exploded(const TriangleSoup& soup) {
    TriangleSoup all;
    all.objects = soup.objects;
    for (const Triangle& t : soup.triangles) {
        const int first = static_cast<int>(all.positions.size());
        for (const int v : t) {
            all.positions.push_back(soup.positions[v]);
        }
        all.triangles.push_back({first, first + 1, first + 2});
    }
    return all;
}

/// Two cubes with a face in common, each of its own vertices.
TriangleSoup touchingBoxes() {
    const TriangleSoup box = weldExactly(boxSoup());
    TriangleSoup both = joined(box, box, Vec3::UnitX());
    both.objects.assign(both.triangles.size(), 0);
    std::fill(both.objects.begin() + std::ptrdiff_t(box.triangles.size()), both.objects.end(), 1);
    return both;
}

TEST(WeldObjects, KeepsSolidsThatTouchApart) {
    const TriangleSoup both = touchingBoxes();
    for (const TriangleSoup& soup : {both, exploded(both)}) {
        const TriangleSoup welded = weldObjects(soup);
        const MeshReport report = inspectTriangles(welded);
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_EQ(report.pieces, 2);
        EXPECT_EQ(report.vertices, 16);
        EXPECT_EQ(welded.objects, both.objects);
    }
    TriangleSoup untold = both;
    untold.objects.clear();
    EXPECT_EQ(inspectTriangles(weldObjects(untold)).pieces, 2) << "closed by their own vertices";
    EXPECT_FALSE(inspectTriangles(weldObjects(exploded(untold))).cuttable) << "nothing parts them";
}

TEST(WeldObjects, KeepsObjectsThatShareTheVerticesOfTheFileApart) {
    TriangleSoup both = weldExactly(touchingBoxes());
    ASSERT_EQ(both.positions.size(), 12u);
    const MeshReport report = inspectTriangles(weldObjects(both));
    EXPECT_TRUE(report.cuttable);
    EXPECT_EQ(report.pieces, 2);
    EXPECT_EQ(report.vertices, 16);
}

TEST(WeldObjects, JoinsPartsThatAreOpenByThemselves) {
    TriangleSoup patches = exploded(weldExactly(boxSoup()));
    for (std::size_t t = 0; t < patches.triangles.size(); ++t) {
        patches.objects.push_back(static_cast<int>(t / 2));
    }
    const TriangleSoup welded = weldObjects(patches);
    EXPECT_TRUE(inspectTriangles(welded).cuttable);
    EXPECT_EQ(welded.positions.size(), 8u);
    EXPECT_EQ(welded.objects, std::vector<int>(12, 0)) << "they hang together";
}

TEST(WeldObjects, LetsAnOpenPartBesideASolidStayAPart) {
    TriangleSoup both = touchingBoxes();
    both.triangles.pop_back();  // of the second box
    both.objects.pop_back();
    const TriangleSoup welded = weldObjects(exploded(both));
    EXPECT_EQ(welded.positions.size(), 16u);
    EXPECT_EQ(inspectTriangles(welded).openEdges, 3);
}

TEST(WeldObjects, FindsASolidThatIsThereTwice) {
    TriangleSoup both = touchingBoxes();
    for (std::size_t v = 8; v < 16; ++v) {
        both.positions[v] = both.positions[v - 8];
    }
    EXPECT_EQ(inspectTriangles(weldObjects(both)).nonManifoldEdges, 18);
}

constexpr unsigned kRaySeed = 20261126;

int windingAt(const TriangleSoup& soup, const Vec3& point) {
    int winding = 0;
    for (const auto& [a, b, c] : soup.triangles) {
        winding += rayCrossing({soup.positions[a], soup.positions[b], soup.positions[c]}, point);
    }
    return winding;
}

TEST(Winding, RaysThroughEdgesVerticesAndPlanesCountOnce) {
    // On this grid rays run through vertices, along edges and within faces.
    const TriangleSoup box = boxSoup(Vec3::Constant(4), 4);
    for (int x = -3; x <= 3; ++x) {
        for (int y = -3; y <= 3; ++y) {
            for (int z = -3; z <= 3; ++z) {
                const Vec3 point(x, y, z);
                const int outermost = point.cwiseAbs().maxCoeff();
                const int winding = windingAt(box, point);
                SCOPED_TRACE(point.transpose());
                if (outermost == 2) {
                    EXPECT_TRUE(winding == 0 || winding == 1) << winding;
                } else {
                    EXPECT_EQ(winding, outermost < 2 ? 1 : 0);
                }
            }
        }
    }
}

TEST(Winding, PointsOfTheSurfaceLieOnOneSideOfIt) {
    std::mt19937 random(kRaySeed);
    std::uniform_int_distribution<int> share(0, 8);
    TriangleSoup ball = icosphereSoup(2, 1);
    for (int run = 0; run < 200; ++run) {
        SCOPED_TRACE(testing::Message() << "seed " << kRaySeed << ", run " << run);
        const Triangle& t = ball.triangles[random() % ball.triangles.size()];
        const double first = share(random) / 8.0;
        const double second = (1 - first) * share(random) / 8.0;
        const Vec3 point = first * ball.positions[t[0]] + second * ball.positions[t[1]] +
                           (1 - first - second) * ball.positions[t[2]];
        const int winding = windingAt(ball, point);
        EXPECT_TRUE(winding == 0 || winding == 1) << winding;
        EXPECT_EQ(windingAt(turned(ball), point), -winding);
    }
}

}  // namespace
}  // namespace kerf
