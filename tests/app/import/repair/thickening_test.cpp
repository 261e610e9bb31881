#include "app/import/repair/thickening.h"

#include "sim/repair/crossings.h"
#include "sim/repair/soup_editing.h"
#include "tests/support/sheet_soup.h"

namespace kerf::app {
namespace {

TriangleSoup without(TriangleSoup soup, const std::function<bool(const Vec3&)>& isGone) {
    std::erase_if(soup.triangles, [&](const Triangle& t) {
        return isGone((soup.positions[t[0]] + soup.positions[t[1]] + soup.positions[t[2]]) / 3);
    });
    return weldExactly(soup);
}

TriangleSoup hemisphere() {
    return without(icosphereSoup(4), [](const Vec3& p) { return p.y() < 0; });
}

/// A band of n quads around the y axis that turns over `halfTurns` times on its way.
TriangleSoup band(int n, int halfTurns) {
    TriangleSoup soup;
    for (int i = 0; i < n; ++i) {
        const double around = 2 * std::numbers::pi * i / n;
        const double turn = halfTurns * around / 2;
        const Vec3 out(std::cos(around), 0, std::sin(around));
        const Vec3 across = 0.2 * (std::cos(turn) * Vec3::UnitY() + std::sin(turn) * out);
        soup.positions.emplace_back(out - across);
        soup.positions.emplace_back(out + across);
    }
    for (int i = 0; i < n; ++i) {
        const bool crosses = i + 1 == n && halfTurns % 2 != 0;
        const int next = 2 * ((i + 1) % n);
        const int low = next + (crosses ? 1 : 0);
        const int high = next + (crosses ? 0 : 1);
        soup.triangles.push_back({2 * i, 2 * i + 1, high});
        soup.triangles.push_back({2 * i, high, low});
    }
    return soup;
}

double areaOf(const TriangleSoup& soup) {
    double area = 0;
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        area += triangleArea(repair::cornersOf(soup, t));
    }
    return area;
}

void expectBody(const TriangleSoup& soup) {
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.problem, "");
    EXPECT_TRUE(repair::crossingTriangles(soup).empty());
    if (report.cuttable) {
        EXPECT_EQ(checkClosedManifold(meshOf(soup)), "");
    }
    TriangleSoup written = soup;
    roundToFloats(written);
    EXPECT_EQ(inspectTriangles(written).problem, "") << "as a file has it";
}

/// Of so many sheets; the volume of what becomes of them.
double thickenedVolume(TriangleSoup soup, double thickness, int sheets = 1) {
    const Thickening done = thicken(soup, thickness);
    EXPECT_EQ(done.problem, "");
    EXPECT_EQ(done.sheets, sheets);
    expectBody(soup);
    return inspectTriangles(soup).volume;
}

std::string problemOf(const TriangleSoup& soup, double thickness) {
    TriangleSoup changed = soup;
    const Thickening done = thicken(changed, thickness);
    EXPECT_EQ(done.sheets, 0);
    EXPECT_EQ(changed.positions, soup.positions) << "a refusal changes nothing";
    EXPECT_EQ(changed.triangles, soup.triangles);
    return done.problem;
}

double proposedFor(TriangleSoup soup) {
    return thicken(soup, 0).thickness;
}

/// The number before " does" in a refusal.
double thicknessTold(const std::string& problem) {
    EXPECT_THAT(problem, HasSubstr(" does"));
    return std::stod(problem.substr(problem.rfind("; ") + 2));
}

TEST(Thickening, MakesABoxOfASquare) {
    for (const int n : {1, 7}) {
        for (const double thickness : {1e-4, 0.03, 5.0}) {
            TriangleSoup soup = sheetSoup(n);
            ASSERT_EQ(thicken(soup, thickness).problem, "");
            expectBody(soup);
            const MeshReport report = inspectTriangles(soup);
            EXPECT_NEAR(report.volume / thickness, 1, 1e-12);
            EXPECT_NEAR(report.bounds.high.y(), thickness / 2, 1e-12) << "half to each side";
            EXPECT_NEAR(report.bounds.low.y(), -thickness / 2, 1e-12);
            EXPECT_EQ(report.triangles, 2 * 2 * n * n + 2 * 4 * n);
        }
    }
}

TEST(Thickening, KeepsTheThicknessOfAFold) {
    const double slope = 1;  // a ridge of 90 degrees
    const double thickness = 0.05;
    TriangleSoup soup = sheetSoup(6, [&](double x, double) { return -slope * std::abs(x - 0.5); });
    const double area = areaOf(soup);
    EXPECT_NEAR(thickenedVolume(soup, thickness), thickness * area, 1e-12);
    ASSERT_EQ(thicken(soup, thickness).problem, "");
    // Each vertex lies half of the thickness off the planes of the faces around it.
    for (const Vec3& p : soup.positions) {
        const double off = std::abs(p.y() + slope * std::abs(p.x() - 0.5)) / std::sqrt(2.0);
        EXPECT_NEAR(off, thickness / 2, 1e-12);
    }
}

TEST(Thickening, ClosesTheBordersOfHoles) {
    const TriangleSoup ring = without(sheetSoup(6), [](const Vec3& p) {
        return std::abs(p.x() - 0.5) < 0.17 && std::abs(p.z() - 0.5) < 0.17;
    });
    const double area = 8.0 / 9;
    EXPECT_NEAR(areaOf(ring), area, 1e-12);
    EXPECT_NEAR(thickenedVolume(ring, 0.02), 0.02 * area, 1e-12);
}

TEST(Thickening, MakesABowlOfAHemisphere) {
    const TriangleSoup soup = hemisphere();
    const double thickness = 0.02;
    EXPECT_NEAR(thickenedVolume(soup, thickness), thickness * areaOf(soup),
                0.002 * thickness * areaOf(soup));
}

TEST(Thickening, MakesABodyOfEachSheet) {
    const TriangleSoup two = joined(sheetSoup(3), sheetSoup(4), Vec3(0, 0.5, 0));
    EXPECT_NEAR(thickenedVolume(two, 0.1, 2), 0.2, 1e-12);
}

TEST(Thickening, TurnsTrianglesThatFaceOtherwise) {
    TriangleSoup soup = sheetSoup(5);
    for (const int t : {3, 4, 20, 31}) {
        std::swap(soup.triangles[t][0], soup.triangles[t][1]);
    }
    EXPECT_NEAR(thickenedVolume(soup, 0.1), 0.1, 1e-12);
}

TEST(Thickening, PartsFansThatMeetInAVertex) {
    const TriangleSoup soup =
        without(sheetSoup(4), [](const Vec3& p) { return (p.x() < 0.5) == (p.z() < 0.5); });
    ASSERT_GT(inspectTriangles(soup).nonManifoldVertices, 0);
    EXPECT_NEAR(thickenedVolume(soup, 0.02, 2), 0.02 * 0.5, 1e-4);
}

TEST(Thickening, LeavesClosedPartsAlone) {
    const TriangleSoup ball = icosphereSoup(2);
    TriangleSoup soup = joined(ball, sheetSoup(3), Vec3(2, 0, 0));
    ASSERT_EQ(thicken(soup, 0.01).sheets, 1);
    expectBody(soup);
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        EXPECT_EQ(soup.triangles[t], ball.triangles[t]);
    }
    for (std::size_t v = 0; v < ball.positions.size(); ++v) {
        EXPECT_EQ(soup.positions[v], ball.positions[v]);
    }
    TriangleSoup closed = ball;
    EXPECT_EQ(thicken(closed, 0.01).sheets, 0);
    EXPECT_EQ(closed.positions, ball.positions);
    EXPECT_EQ(proposedFor(ball), 0);
}

TEST(Thickening, PutsTheLooksOnBothSides) {
    TriangleSoup soup = sheetSoup(2);
    const auto count = static_cast<int>(soup.triangles.size());
    const auto uvOf = [](const Vec3& p) { return Vec2(p.x(), p.z()).cast<float>().eval(); };
    resizeAttributes(soup.skin, 0);
    for (int t = 0; t < count; ++t) {
        const Corners at = repair::cornersOf(soup, t);
        soup.skin.uvs.push_back({uvOf(at[0]), uvOf(at[1]), uvOf(at[2])});
        soup.skin.materials.push_back(t % 3);
        CornerColors& colors = soup.skin.colors.emplace_back();
        for (int i = 0; i < 3; ++i) {
            colors[i] << uvOf(at[i]), 0, 1;
        }
    }
    const std::vector<int> before = soup.skin.materials;
    ASSERT_EQ(thicken(soup, 0.1).problem, "");
    ASSERT_EQ(soup.skin.uvs.size(), soup.triangles.size());
    ASSERT_EQ(soup.skin.colors.size(), soup.triangles.size());
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const Corners at = repair::cornersOf(soup, t);
        for (int i = 0; i < 3 && t < 2 * count; ++i) {
            EXPECT_TRUE(soup.skin.uvs[t][i].isApprox(uvOf(at[i]), 1e-6F)) << "triangle " << t;
            EXPECT_TRUE(soup.skin.colors[t][i].head<2>().isApprox(uvOf(at[i]), 1e-6F));
        }
    }
    for (int t = 0; t < count; ++t) {
        EXPECT_EQ(soup.skin.materials[t], before[t]);
        EXPECT_EQ(soup.skin.materials[count + t], before[t]);
    }
    // A strip has the material of a triangle with its edge, and the image inside of that: at the
    // edge itself it may repeat.
    const Bounds all = boxOf(soup.positions);
    for (int t = 2 * count; t < static_cast<int>(soup.triangles.size()); ++t) {
        EXPECT_GE(soup.skin.materials[t], 0);
        for (const Eigen::Vector2f& uv : soup.skin.uvs[t]) {
            const double inside = std::min({uv.x() - all.low.x(), all.high.x() - uv.x(),
                                            uv.y() - all.low.z(), all.high.z() - uv.y()});
            EXPECT_GT(inside, 0.05 * (all.high.x() - all.low.x()));
        }
    }
}

TEST(Thickening, RefusesWhatHasOneSide) {
    EXPECT_THAT(problemOf(band(24, 1), 0.01), HasSubstr("one side alone"));
    EXPECT_EQ(proposedFor(band(24, 1)), 0);
    EXPECT_GT(thickenedVolume(band(24, 2), 0.01), 0) << "turned over twice it has two";
}

TEST(Thickening, RefusesBranchesAndTrianglesWithoutArea) {
    const auto with = [](int n, int a, int b, const Vec3& apex) {
        TriangleSoup soup = sheetSoup(n);
        soup.triangles.push_back({a, b, static_cast<int>(soup.positions.size())});
        soup.positions.push_back(apex);
        return soup;
    };
    EXPECT_THAT(problemOf(with(2, 4, 5, {0.5, 1, 0.5}), 0.01),
                StartsWith("1 edge with more than two triangles"));
    EXPECT_THAT(problemOf(with(1, 0, 1, {0.5, 0, 0}), 0.01), StartsWith("1 triangle without area"));
    EXPECT_THAT(problemOf(with(1, 0, 1, {3, 1e-200, 0}), 0.01), HasSubstr("nearly without area"));
}

TEST(Thickening, SaysWhichThicknessDoes) {
    const auto wave = [](double x, double z) { return 0.05 * std::sin(20 * x) * std::cos(20 * z); };
    const TriangleSoup near = joined(sheetSoup(4), sheetSoup(4), Vec3(0.01, 0.02, 0));
    for (const TriangleSoup& soup : {sheetSoup(40, wave), hemisphere(), near}) {
        const double told = thicknessTold(problemOf(soup, 1.5));
        EXPECT_GT(told, 0.005);
        TriangleSoup thinner = soup;
        EXPECT_EQ(thicken(thinner, told).problem, "");
        expectBody(thinner);
    }
    EXPECT_THAT(problemOf(sheetSoup(3), 1e-9), HasSubstr("too little"));
    EXPECT_THAT(problemOf(sheetSoup(3), std::nan("")), HasSubstr("too little"));
    EXPECT_THAT(problemOf(sheetSoup(3), HUGE_VAL), HasSubstr("too much"));
}

TEST(Thickening, RefusesASheetThatPassesThroughItself) {
    // A spiral ramp whose end goes through its beginning.
    TriangleSoup soup = sheetSoup(12, [](double, double) { return 0.0; });
    for (Vec3& p : soup.positions) {
        const double around = 3 * std::numbers::pi * p.x();
        p = Vec3(std::cos(around) * (1 + 0.2 * std::sin(around / 2)), p.z(), std::sin(around));
    }
    ASSERT_FALSE(repair::crossingTriangles(soup).empty());
    EXPECT_THAT(problemOf(soup, 0.01), StartsWith("no thickness does"));
}

TEST(Thickening, LetsSheetsPassThroughEachOther) {
    TriangleSoup upright = sheetSoup(2);
    for (Vec3& p : upright.positions) {
        p = Vec3(p.x(), p.z() - 0.4, 0.51);
    }
    TriangleSoup soup = joined(sheetSoup(3), upright, Vec3::Zero());
    EXPECT_EQ(thicken(soup, 0.02).problem, "") << "as leaves do; a repair unites them";
    EXPECT_EQ(inspectTriangles(soup).problem, "");
}

TEST(Thickening, ProposesAFiftiethOfTheDiagonalOrLess) {
    EXPECT_NEAR(proposedFor(sheetSoup(4)), std::sqrt(2.0) / 50, 0.0005);
    const TriangleSoup near = joined(sheetSoup(4), sheetSoup(4), Vec3(0, 0.01, 0));
    const double less = proposedFor(near);
    EXPECT_LT(less, 0.01);
    EXPECT_GT(less, 0.004);
    TriangleSoup soup = near;
    EXPECT_EQ(thicken(soup, less).sheets, 2);
}

TEST(Thickening, TellsSheetsFromBodiesWithHoles) {
    EXPECT_TRUE(isSheet(sheetSoup(3)));
    EXPECT_TRUE(isSheet(hemisphere()));
    EXPECT_FALSE(isSheet(icosphereSoup(2)));
    const TriangleSoup holes = without(icosphereSoup(4), [](const Vec3& p) {
        return std::abs(p.y()) > 0.47 || std::abs(p.x()) > 0.47 || std::abs(p.z()) > 0.47;
    });
    EXPECT_FALSE(isSheet(holes));
}

// KERF_FUZZ_SEED sets the seed.
TEST(Thickening, MakesBodiesOfRandomHeightFields) {
    std::mt19937 random(fuzzSeed(20261127));
    const auto any = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / std::mt19937::max();
    };
    for (int i = 0; i < 30; ++i) {
        SCOPED_TRACE(i);
        const double rough = any(0, 0.03);
        TriangleSoup soup = sheetSoup(4 + static_cast<int>(random() % 20),
                                      [&](double, double) { return any(-rough, rough); });
        for (int gone = static_cast<int>(random() % 9); gone > 0; --gone) {
            soup.triangles.erase(soup.triangles.begin() +
                                 static_cast<std::ptrdiff_t>(random() % soup.triangles.size()));
        }
        soup = weldExactly(soup);
        const double wanted = any(0.001, 0.2);
        TriangleSoup body = soup;
        const std::string problem = thicken(body, wanted).problem;
        const double thickness = problem.empty() ? wanted : thicknessTold(problem);
        if (!problem.empty()) {
            ASSERT_EQ(thicken(body, thickness).problem, "");
        }
        expectBody(body);
        const double volume = inspectTriangles(body).volume;
        EXPECT_GT(volume, 0.5 * thickness * areaOf(soup));
        EXPECT_LT(volume, 1.5 * thickness * areaOf(soup));
    }
}

}  // namespace
}  // namespace kerf::app
