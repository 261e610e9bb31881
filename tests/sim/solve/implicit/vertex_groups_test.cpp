#include "sim/solve/implicit/vertex_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/cut_ball.h"

namespace kerf {
namespace {

/// The number of groups that each vertex is in.
std::vector<int> countsOf(const std::vector<VertexGroup>& groups, std::size_t vertexCount) {
    std::vector<int> counts(vertexCount, 0);
    for (const VertexGroup& group : groups) {
        for (const std::uint32_t v : group) {
            ++counts[v];
        }
    }
    return counts;
}

class VertexGroupsTest : public testing::Test {
  protected:
    BodyModel model = buildBodyModel(test::cutBall(-0.06, 12));
    /// Far from the front the walls of the slit hold together around the ball alone.
    bool hasBothWalls(const VertexGroup& group) const {
        bool before = false;
        bool behind = false;
        for (const std::uint32_t v : group) {
            const Vec3f& p = model.restPositions[v];
            if (p.y() > 0) {
                before = before || p.z() > 0.0031F;
                behind = behind || p.z() < 0.0029F;
            }
        }
        return before && behind;
    }

    VertexGroups groups = groupVertices(model, pullsAtRest(model, {1e5, 1e5, 1e5}), 60);
};

TEST_F(VertexGroupsTest, HaveEachVertexOnce) {
    const std::size_t count = model.restPositions.size();
    const std::vector<int> inPatches = countsOf(groups.patches, count);
    const std::vector<int> inAggregates = countsOf(groups.aggregates, count);
    for (std::size_t v = 0; v < count; ++v) {
        const int expected = model.pieceOfVertex[v] >= 0 ? 1 : 0;
        EXPECT_EQ(inPatches[v], expected);
        EXPECT_EQ(inAggregates[v], expected);
    }
    for (const VertexGroup& patch : groups.patches) {
        EXPECT_LE(patch.size(), kMostOfPatch);
    }
    EXPECT_LT(groups.patches.size(), count / 8);
    for (const VertexGroup& aggregate : groups.aggregates) {
        EXPECT_LE(aggregate.size(), 120U);  // the kernels have room for shared::kMostMembers
    }
}

TEST_F(VertexGroupsTest, AggregatesAreWholePatches) {
    std::vector<int> aggregateOf(model.restPositions.size(), -1);
    for (std::size_t a = 0; a < groups.aggregates.size(); ++a) {
        for (const std::uint32_t v : groups.aggregates[a]) {
            aggregateOf[v] = static_cast<int>(a);
        }
    }
    for (const VertexGroup& patch : groups.patches) {
        for (const std::uint32_t v : patch) {
            EXPECT_EQ(aggregateOf[v], aggregateOf[patch[0]]);
        }
    }
}

TEST_F(VertexGroupsTest, ManyAggregatesFormRegionsOfWhatHangsTogether) {
    EXPECT_FALSE(groups.hasLevelBetween());
    model = buildBodyModel(test::cutBall(-0.06, 16));
    groups = groupVertices(model, pullsAtRest(model, {1e5, 1e5, 1e5}), kPatchSize);
    ASSERT_GT(groups.aggregates.size(), kMostAggregates);
    EXPECT_TRUE(groups.hasLevelBetween());
    EXPECT_LE(groups.regions.size(), 2 * kRegions);
    std::vector<int> counts(groups.aggregates.size(), 0);
    for (const std::vector<std::uint32_t>& region : groups.regions) {
        for (const std::uint32_t a : region) {
            ++counts[a];
        }
    }
    EXPECT_THAT(counts, testing::Each(1));
    for (const std::vector<std::uint32_t>& region : groups.regions) {
        EXPECT_FALSE(hasBothWalls(groups.verticesOf(region)));
    }
}

TEST_F(VertexGroupsTest, NoAggregateHasBothWallsOfASlit) {
    for (const VertexGroup& aggregate : groups.aggregates) {
        EXPECT_FALSE(hasBothWalls(aggregate));
    }
}

}  // namespace
}  // namespace kerf
