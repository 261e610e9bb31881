#include "sim/repair/fault_finder.h"

#include "tests/support/model_defects.h"

namespace kerf {
namespace {

using repair::FaultKind;
using repair::Faults;

/// The counts of the kinds that are there.
std::map<FaultKind, int> countsOf(const TriangleSoup& soup) {
    const Faults faults = repair::findFaults(soup);
    std::map<FaultKind, int> counts;
    for (int k = 0; k < repair::kFaultKinds; ++k) {
        const auto kind = static_cast<FaultKind>(k);
        if (faults.of(kind).count() > 0) {
            counts[kind] = faults.of(kind).count();
        }
    }
    return counts;
}

/// What a report counts must be what is found.
void expectAsReported(const TriangleSoup& soup) {
    const Faults faults = repair::findFaults(soup);
    MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(faults.of(FaultKind::openEdge).count(), report.openEdges);
    EXPECT_EQ(faults.of(FaultKind::branchingEdge).count(), report.nonManifoldEdges);
    EXPECT_EQ(faults.of(FaultKind::touchingVertex).count(), report.nonManifoldVertices);
    EXPECT_EQ(faults.of(FaultKind::opposedEdge).count(), report.misorientedEdges);
    EXPECT_EQ(faults.of(FaultKind::flatTriangle).count(), report.degenerateTriangles);
    if (report.outOfRangeIndices == 0) {
        countCrossings(soup, report);
        EXPECT_EQ(faults.of(FaultKind::crossingTriangle).count(), report.crossingTriangles);
    }
}

/// The triangles at an edge, counted plainly.
int trianglesAt(const TriangleSoup& soup, const SurfaceFaults::Edge& edge) {
    int found = 0;
    for (const Triangle& t : soup.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::set<int> side{t[i], t[(i + 1) % 3]};
            found += side == std::set<int>{edge[0], edge[1]} ? 1 : 0;
        }
    }
    return found;
}

TEST(FaultFinder, FindsNothingInSoundModels) {
    EXPECT_FALSE(repair::findFaults(soundBall()).any());
    EXPECT_FALSE(repair::findFaults(torusSoup()).any());
    EXPECT_FALSE(repair::findFaults({}).any());
}

TEST(FaultFinder, FindsTheBorderOfAHole) {
    TriangleSoup soup = boxSoup();
    const Triangle gone = soup.triangles.front();
    soup.triangles.erase(soup.triangles.begin());
    EXPECT_EQ(countsOf(soup), (std::map<FaultKind, int>{{FaultKind::openEdge, 3}}));
    std::set<int> ends;
    const auto faults = repair::findFaults(soup);
    for (const auto& [a, b] : faults.of(FaultKind::openEdge).edges) {
        ends.insert({a, b});
    }
    EXPECT_THAT(ends, UnorderedElementsAre(gone[0], gone[1], gone[2]));
}

TEST(FaultFinder, FindsWhereASurfaceBranches) {
    TriangleSoup soup = boxSoup();
    const Triangle& first = soup.triangles.front();
    const int a = first[0];
    const int b = first[1];
    const auto tip = static_cast<int>(soup.positions.size());
    soup.positions.emplace_back(0, 5, 0);
    soup.triangles.push_back({a, b, tip});
    const Faults faults = repair::findFaults(soup);
    EXPECT_THAT(faults.of(FaultKind::branchingEdge).edges,
                ElementsAre(SurfaceFaults::Edge{std::min(a, b), std::max(a, b)}));
    EXPECT_EQ(faults.of(FaultKind::openEdge).count(), 2);
}

TEST(FaultFinder, FindsVerticesWhereASurfaceTouchesItself) {
    const TriangleSoup soup = weldExactly(joined(boxSoup(), boxSoup(), Vec3(1, 1, 1)));
    const Faults faults = repair::findFaults(soup);
    ASSERT_EQ(faults.of(FaultKind::touchingVertex).count(), 1);
    const Vec3& at = soup.positions[faults.of(FaultKind::touchingVertex).vertices[0]];
    EXPECT_NEAR((at - Vec3(0.5, 0.5, 0.5)).norm(), 0, 1e-12);
    EXPECT_EQ(countsOf(soup).size(), 1U);
}

TEST(FaultFinder, FindsTrianglesThatFaceOtherwise) {
    TriangleSoup soup = boxSoup();
    turnTriangle(soup, 4);
    EXPECT_EQ(countsOf(soup), (std::map<FaultKind, int>{{FaultKind::opposedEdge, 3}}));
}

TEST(FaultFinder, FindsTrianglesWithoutAreaAndDoubles) {
    TriangleSoup soup = boxSoup();
    const Triangle first = soup.triangles.front();
    soup.triangles.push_back({first[1], first[2], first[0]});
    soup.triangles.push_back({first[1], first[0], first[2]});
    soup.triangles.push_back({first[0], first[0], first[1]});
    const Faults faults = repair::findFaults(soup);
    EXPECT_THAT(faults.of(FaultKind::doubleTriangle).triangles, ElementsAre(12, 13));
    EXPECT_THAT(faults.of(FaultKind::flatTriangle).triangles, ElementsAre(14));
}

TEST(FaultFinder, FindsTrianglesThatPassThroughOthers) {
    const TriangleSoup soup = joined(boxSoup(), boxSoup(), Vec3(0.51, 0.37, 0.23));
    const std::map<FaultKind, int> counts = countsOf(soup);
    EXPECT_EQ(counts.size(), 1U);
    EXPECT_GT(counts.at(FaultKind::crossingTriangle), 4);
    EXPECT_FALSE(repair::findFaults(soup, false).any());
}

TEST(FaultFinder, FindsNeedles) {
    EXPECT_EQ(countsOf(boxSoup(Vec3(1, 20, 1))),
              (std::map<FaultKind, int>{{FaultKind::needle, 8}}));
    EXPECT_TRUE(countsOf(boxSoup(Vec3(1, 9, 1))).empty());
}

TEST(FaultFinder, LeavesOutWhatHasNoPlace) {
    TriangleSoup soup = boxSoup();
    soup.positions[soup.triangles[0][0]].x() = std::numeric_limits<double>::quiet_NaN();
    soup.triangles.push_back({0, 1, 99});
    const auto faults = repair::findFaults(soup);
    for (const int t : faults.of(FaultKind::needle).triangles) {
        for (const int v : soup.triangles[t]) {
            EXPECT_TRUE(soup.positions.at(v).allFinite());
        }
    }
    expectAsReported(soup);
}

TEST(FaultFinder, CountsAsTheReportDoesForEachPairOfDefects) {
    for (const auto& [first, spoil] : modelDefects()) {
        for (const auto& [second, spoilMore] : modelDefects()) {
            SCOPED_TRACE(std::string(first).append(" and ").append(second));
            TriangleSoup soup = soundBall();
            spoil(soup);
            spoilMore(soup);
            expectAsReported(soup);
        }
    }
}

TEST(FaultFinder, FindsWhatAPlainCountFindsInWhateverComes) {
    std::mt19937 random(fuzzSeed(20261123));
    constexpr int kRuns = 60;
    for (int run = 0; run < kRuns; ++run) {
        SCOPED_TRACE(run);
        TriangleSoup soup = icosphereSoup(1);
        damage(soup, random, 8);
        expectAsReported(soup);
        std::erase_if(soup.triangles, [](const Triangle& t) {
            return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        });
        const Faults faults = repair::findFaults(soup, false);
        for (const SurfaceFaults::Edge& edge : faults.of(FaultKind::openEdge).edges) {
            EXPECT_EQ(trianglesAt(soup, edge), 1);
        }
        for (const SurfaceFaults::Edge& edge : faults.of(FaultKind::branchingEdge).edges) {
            EXPECT_GT(trianglesAt(soup, edge), 2);
        }
        for (const SurfaceFaults::Edge& edge : faults.of(FaultKind::opposedEdge).edges) {
            EXPECT_EQ(trianglesAt(soup, edge), 2);
        }
    }
}

}  // namespace
}  // namespace kerf
