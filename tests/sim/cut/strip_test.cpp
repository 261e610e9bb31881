#include <gtest/gtest.h>

#include <random>

#include "sim/cut/plan/strip/swept_strip.h"

namespace kerf::cut {
namespace {

/// Two rungs between x = 0 and x = 1; nodes of the lower one first.
struct Rungs {
    std::vector<int> lower, upper;
    std::vector<double> lowerS, upperS;
    std::vector<Vec2> at;
};

void addLower(Rungs& rungs, double s, double y = 0) {
    rungs.lower.push_back(static_cast<int>(rungs.at.size()));
    rungs.lowerS.push_back(s);
    rungs.at.push_back({s, y});
}

void addUpper(Rungs& rungs, double s, double y = 1) {
    rungs.upper.push_back(static_cast<int>(rungs.at.size()));
    rungs.upperS.push_back(s);
    rungs.at.push_back({s, y});
}

Rungs randomRungs(std::mt19937_64& engine, bool pinStart, bool pinEnd) {
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(engine() % static_cast<std::uint64_t>(high - low + 1));
    };
    Rungs rungs;
    const int below = between(1, 8), above = between(1, 8);
    for (int i = 0; i <= below; ++i) {
        addLower(rungs, i / static_cast<double>(below));
    }
    for (int j = 0; j <= above; ++j) {
        const bool pinned = (j == 0 && pinStart) || (j == above && pinEnd);
        if (pinned) {
            rungs.upper.push_back(j == 0 ? rungs.lower.front() : rungs.lower.back());
            rungs.upperS.push_back(j == 0 ? 0 : 1);
        } else {
            addUpper(rungs, j / static_cast<double>(above));
        }
    }
    return rungs;
}

bool allOn(const Triangle& t, const std::vector<int>& rung) {
    return std::all_of(t.begin(), t.end(), [&](int node) {
        return std::find(rung.begin(), rung.end(), node) != rung.end();
    });
}

double signedArea(const Rungs& rungs, const Triangle& t) {
    const Vec2 u = rungs.at[t[1]] - rungs.at[t[0]];
    const Vec2 v = rungs.at[t[2]] - rungs.at[t[0]];
    return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

double polygonArea(const Rungs& rungs) {
    std::vector<Vec2> border;
    for (const int node : rungs.lower) {
        border.push_back(rungs.at[node]);
    }
    for (int j = static_cast<int>(rungs.upper.size()) - 1; j >= 0; --j) {
        border.push_back(rungs.at[rungs.upper[j]]);
    }
    double area = 0;
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Vec2& p = border[i];
        const Vec2& q = border[(i + 1) % border.size()];
        area += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    return area;
}

void expectGoodZip(const Rungs& rungs) {
    const std::vector<Triangle> triangles =
        stitch(rungs.lower, rungs.lowerS, rungs.upper, rungs.upperS);
    double area = 0;
    for (const Triangle& t : triangles) {
        EXPECT_FALSE(allOn(t, rungs.lower)) << "three nodes on the old rung";
        EXPECT_FALSE(allOn(t, rungs.upper)) << "three nodes on the new rung";
        EXPECT_GT(signedArea(rungs, t), 0);
        area += signedArea(rungs, t);
    }
    EXPECT_NEAR(area, polygonArea(rungs), 1e-12);
}

TEST(Strip, ZipCoversTheBand) {
    std::mt19937_64 engine(5);
    for (int i = 0; i < 200; ++i) {
        expectGoodZip(randomRungs(engine, false, false));
    }
}

TEST(Strip, ZipWithAPinnedEndLeavesNoTriangleOnOneRung) {
    std::mt19937_64 engine(6);
    for (int i = 0; i < 200; ++i) {
        expectGoodZip(randomRungs(engine, true, false));
        expectGoodZip(randomRungs(engine, false, true));
    }
}

TEST(Strip, ZipWithBothEndsPinnedCoversALens) {
    Rungs rungs;
    addLower(rungs, 0);
    addLower(rungs, 0.3, -0.2);
    addLower(rungs, 0.7, -0.2);
    addLower(rungs, 1);
    rungs.upper = {rungs.lower.front()};
    rungs.upperS = {0};
    addUpper(rungs, 0.5, 0.3);
    rungs.upper.push_back(rungs.lower.back());
    rungs.upperS.push_back(1);
    expectGoodZip(rungs);
}

// The strip would fold back behind a front whose end is steep, and cut the walls there again.
TEST(Strip, AnInnerFrontNodeIsJoinedToThePointAboveItNotToTheEndOfTheBlade) {
    const std::vector<Triangle> triangles =
        stitch({0, 1, 2, 3, 4}, {0, 0.55, 0.56, 0.64, 1}, {5, 6, 7}, {0, 0.56, 1});
    for (const Triangle& t : triangles) {
        const auto has = [&](int node) { return std::find(t.begin(), t.end(), node) != t.end(); };
        EXPECT_FALSE(has(2) && (has(5) || has(7)));
    }
}

}  // namespace
}  // namespace kerf::cut
