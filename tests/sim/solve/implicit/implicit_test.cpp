#include "sim/solve/implicit/coarse_matrix.h"
#include "sim/solve/implicit/step_choice.h"
#include "sim/solve/implicit/vertex_groups.h"

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
    BodyModel model = buildBodyModel(cutBall(-0.06, 12));
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
    model = buildBodyModel(cutBall(-0.06, 16));
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
    EXPECT_THAT(counts, Each(1));
    for (const std::vector<std::uint32_t>& region : groups.regions) {
        EXPECT_FALSE(hasBothWalls(groups.verticesOf(region)));
    }
}

TEST_F(VertexGroupsTest, NoAggregateHasBothWallsOfASlit) {
    for (const VertexGroup& aggregate : groups.aggregates) {
        EXPECT_FALSE(hasBothWalls(aggregate));
    }
}

BodyEnergies moving(double kinetic, double strain = 0) {
    return {kinetic + strain, 0};
}

class EnergyGuardTest : public testing::Test {
  protected:
    EnergyGuardTest() { note(moving(1)); }

    bool note(const BodyEnergies& body, bool worked = false) {
        return guard.note(body, 1.0 / 240, worked, 1e-3);
    }

    EnergyGuard guard;
};

TEST_F(EnergyGuardTest, DividesWhatGrowsFurtherEachTimeUpToAnEighth) {
    double energy = 1;
    for (const int expected : {2, 4, 8, 8}) {
        energy *= 1.6;
        const int before = guard.divisions();
        EXPECT_EQ(note(moving(energy)), expected > before);
        EXPECT_EQ(guard.divisions(), expected);
    }
}

TEST_F(EnergyGuardTest, LetsEnergyChangeItsKind) {
    EXPECT_FALSE(note(moving(0.2, 0.8)));
    EXPECT_FALSE(note(moving(0.1, 0.5)));  // the rest is in contacts
    EXPECT_FALSE(note(moving(0.9)));
    EXPECT_EQ(guard.divisions(), 1);
}

TEST_F(EnergyGuardTest, LetsGrowWhatIsWorkedOnOrNew) {
    EXPECT_FALSE(note(moving(5), true));
    guard.startAnew();
    EXPECT_FALSE(note(moving(20)));
    EXPECT_TRUE(note(moving(31)));
}

TEST_F(EnergyGuardTest, LetsLittleEnergyBe) {
    guard.startAnew();
    note(moving(1e-5));
    EXPECT_FALSE(note(moving(1e-4)));
}

TEST_F(EnergyGuardTest, GoesBackAfterSecondsWithoutGrowth) {
    note(moving(2));
    note(moving(4));
    ASSERT_EQ(guard.divisions(), 4);
    for (int step = 0; step < 485; ++step) {
        note(moving(1));
    }
    EXPECT_EQ(guard.divisions(), 1);
}

using Eigen::MatrixXd;
constexpr int kRows = CoarseMatrix::kRows;

/// A chain of blocks, all linked to the first one, too.
CoarseMatrix chainOf(int count) {
    CoarseMatrix matrix(count);
    for (int i = 0; i < count; ++i) {
        matrix.at(i, i) = 5 * CoarseMatrix::Block::Identity();
        matrix.at(i, 0) += 0.1 * CoarseMatrix::Block::Ones();
        if (i > 1) {
            matrix.at(i, i - 1) = 0.1 * CoarseMatrix::Block::Constant(i).cwiseInverse();
            matrix.at(i, i - 1).triangularView<Eigen::StrictlyUpper>().setZero();
        }
    }
    return matrix;
}

TEST(CoarseMatrixTest, TimesItsInverseIsOne) {
    constexpr int kCount = 9;
    CoarseMatrix chain = chainOf(kCount);
    MatrixXd dense(kRows * kCount, kRows * kCount);
    const auto [places, inverse] = chainOf(kCount).invert();
    for (int i = 0; i < kCount; ++i) {
        for (int j = 0; j <= i; ++j) {
            dense.block<kRows, kRows>(kRows * places[i], kRows * places[j]) = chain.at(i, j);
            dense.block<kRows, kRows>(kRows * places[j], kRows * places[i]) =
                chain.at(i, j).transpose();
        }
    }
    EXPECT_TRUE((dense * inverse).isIdentity(1e-12));
    EXPECT_EQ(inverse, inverse.transpose());
}

}  // namespace
}  // namespace kerf
