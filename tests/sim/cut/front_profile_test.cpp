#include "sim/cut/plan/strip/front_profile.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/cut/plan/strip/swept_strip.h"

namespace kerf::cut {
namespace {

const Blade kBlade{{0, 1, 0}, {1, 1, 0}};

/// From a front of such heights between x = 0 and x = 1 to the blade; vertex i is node i.
Strip stripOver(const std::vector<double>& heights) {
    Strip strip;
    const int last = sizeOf(heights) - 1;
    std::vector<int> lower;
    std::vector<double> lowerS;
    for (int i = 0; i <= last; ++i) {
        StripNode& node = strip.nodes.emplace_back();
        node.s = i / static_cast<double>(last);
        node.position = {node.s, heights[i], 0};
        node.vertices = {i};
        lower.push_back(i);
        lowerS.push_back(node.s);
    }
    strip.oldCount = last + 1;
    for (const double s : {0.0, 0.3, 0.6, 1.0}) {
        strip.newRung.push_back(sizeOf(strip.nodes));
        StripNode& node = strip.nodes.emplace_back();
        node.s = s;
        node.position = {s, 1, 0};
    }
    strip.triangles = stitch(lower, lowerS, strip.newRung, {0.0, 0.3, 0.6, 1.0});
    for (const Triangle& t : strip.triangles) {
        for (int e = 0; e < 3; ++e) {
            strip.edges.push_back({t[e], t[(e + 1) % 3]});
        }
    }
    return strip;
}

double cross(const Vec3& p, const Vec3& q, const Vec3& r) {
    return (q - p).cross(r - p).z();
}

bool isInside(const Strip& strip, const Triangle& t, const Vec3& p) {
    for (int e = 0; e < 3; ++e) {
        if (cross(strip.nodes[t[e]].position, strip.nodes[t[(e + 1) % 3]].position, p) <= 0) {
            return false;
        }
    }
    return true;
}

TEST(FrontProfile, TellsWallsBehindAStraightFront) {
    const Strip strip = stripOver({0, 0, 0, 0, 0});
    const FrontProfile front(kBlade, strip);
    const auto at = [&](int node) { return strip.nodes[node].position; };
    const Vec3 behind(0.4, -0.2, 0);
    const Vec3 fartherBehind(0.3, -0.3, 0.1);
    EXPECT_TRUE(front.isBehind({1, 2, 9}, {at(1), at(2), behind})) << "with an edge of the front";
    EXPECT_TRUE(front.isBehind({2, 8, 9}, {at(2), fartherBehind, behind})) << "with a vertex";
    EXPECT_TRUE(front.isBehind({7, 8, 9}, {fartherBehind, behind, {0.6, -0.1, 0}}));
    EXPECT_FALSE(front.isBehind({1, 3, 9}, {at(1), at(3), behind})) << "over node 2";
    EXPECT_FALSE(front.isBehind({1, 7, 9}, {at(1), at(2), behind})) << "a copy of vertex 2";
    EXPECT_FALSE(front.isBehind({2, 8, 9}, {at(2), behind, {0.6, 0.1, 0}})) << "ahead";
    EXPECT_FALSE(front.isBehind({2, 8, 9}, {at(2), behind, {-0.1, -0.1, 0}})) << "beside";
}

TEST(FrontProfile, NothingIsBehindAFrontThatRunsBack) {
    Strip strip = stripOver({0, 0, 0, 0, 0});
    strip.nodes[2].position.x() = 0.2;
    const FrontProfile front(kBlade, strip);
    EXPECT_FALSE(front.isBehind({7, 8, 9}, {Vec3(0.4, -0.2, 0), {0.3, -0.3, 0}, {0.5, -0.3, 0}}));
}

// Along fronts as jagged as no stroke makes them.
TEST(FrontProfile, WhatIsBehindLiesInNoTriangleOfTheStrip) {
    constexpr unsigned kSeed = 11;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    std::mt19937 random{kSeed};
    std::uniform_real_distribution<double> uniform{0, 1};
    int behind = 0;
    for (int i = 0; i < 4000; ++i) {
        std::vector<double> heights(6);
        for (double& height : heights) {
            height = 0.5 * uniform(random);
        }
        const Strip strip = stripOver(heights);
        const FrontProfile front(kBlade, strip);
        Triangle ids{};
        std::array<Vec3, 3> corners;
        for (int k = 0; k < 3; ++k) {
            const bool isNode = uniform(random) < 0.4;
            ids[k] = isNode ? static_cast<int>(6 * uniform(random)) : 100 + k;
            corners[k] = isNode ? strip.nodes[ids[k]].position
                                : Vec3(uniform(random), 0.6 * uniform(random) - 0.3, 0);
        }
        const bool hasArea = ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0];
        if (!hasArea || !front.isBehind(ids, corners)) {
            continue;
        }
        ++behind;
        for (int k = 0; k < 50; ++k) {
            const double a = uniform(random);
            const double b = uniform(random) * (1 - a);
            const Vec3 p = a * corners[0] + b * corners[1] + (1 - a - b) * corners[2];
            for (const Triangle& t : strip.triangles) {
                EXPECT_FALSE(isInside(strip, t, p)) << "front " << i;
            }
        }
    }
    EXPECT_GT(behind, 300);
}

}  // namespace
}  // namespace kerf::cut
