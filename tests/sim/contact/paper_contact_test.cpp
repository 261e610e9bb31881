#include "sim/contact/paper_contact.h"

#include "tests/support/reference/octree.h"
#include "tests/support/reference/reference_paper_contact.h"

namespace kerf {
namespace {

constexpr unsigned kSeed = 5;

TEST(OctreeTest, FindsAllThatOverlap) {
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> place(-1, 1);
    const auto drawnBox = [&](double size) {
        Bounds box;
        box.add(Vec3(place(random), place(random), place(random)));
        box.add(Vec3(box.low + size * Vec3::Constant(1 + place(random))));
        return box;
    };
    std::vector<Bounds> boxes(500);
    std::ranges::generate(boxes, [&] { return drawnBox(0.1); });
    boxes.resize(520, boxes[0]);  // some in one place
    const Octree tree(boxes);
    for (int query = 0; query < 50; ++query) {
        const Bounds around = drawnBox(0.3);
        std::vector<int> found;
        tree.query(around, [&](int item) { found.push_back(item); });
        std::ranges::sort(found);
        std::vector<int> expected;
        for (int i = 0; i < 520; ++i) {
            if (boxes[i].overlaps(around)) {
                expected.push_back(i);
            }
        }
        EXPECT_EQ(found, expected) << "seed " << kSeed << " query " << query;
    }
}

Params publishedParams() {
    Params params;
    params.solver = SolverMode::pbd;
    params.paperContact = 1;
    params.gravity.setZero();
    params.floor.reset();
    return params;
}

/// A body on the GPU whose pieces respond to each other, and nothing else.
struct Pieces {
    explicit Pieces(const SurfaceMesh& mesh)
        : model(buildBodyModel(mesh)),
          state(stateOf(mesh)),
          settings(contactSettings(publishedParams())) {
        gpu.setModel(model, state);
        gpu.setUniforms(solverUniforms(publishedParams(), model));
        gpu.collisions().setSettings(settings);
    }

    /// On the GPU. Returns how many pairs of triangles met.
    int respond() {
        gpu.collisions().respondAsThePaper();
        const int pairs = gpu.measure().contacts;
        state = gpu.readState();
        return pairs;
    }

    double meanHeight(std::size_t first, std::size_t end) const {
        double sum = 0;
        for (std::size_t v = first; v < end; ++v) {
            sum += state.positions[v].y();
        }
        return sum / static_cast<double>(end - first);
    }

    BodyModel model;
    BodyState state;
    ContactSettings settings;
    GpuSolver gpu;
};

/// Two blocks of which the upper one stands 2 cm in the lower one.
struct Blocks {
    TriangleSoup lower = boxSoup({0.6, 0.4, 0.6}, 3);
    SurfaceMesh mesh = meshOf(joined(lower, boxSoup({0.5, 0.4, 0.5}, 4), {0.01, 0.38, 0.02}));
    int firstOfUpper = static_cast<int>(lower.positions.size());

    explicit Blocks(double upperSpeed) {
        for (int v = firstOfUpper; v < mesh.vertexCount(); ++v) {
            mesh.setVelocity(v, {0, upperSpeed, 0});
        }
    }
};

/// Three bodies of unlike fineness, far into each other and shaken.
SurfaceMesh shakenCluster(unsigned seed) {
    const TriangleSoup two =
        joined(cubeSphereSoup(5, 0.4), icosphereSoup(3, 0.3), {0.31, 0.33, 0.05});
    SurfaceMesh mesh = meshOf(joined(two, icosphereSoup(0, 0.5), {-0.5, 0.4, 0.13}));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    const auto vector = [&] { return Vec3(noise(random), noise(random), noise(random)); };
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) + 0.01 * vector());
        mesh.setVelocity(v, 3 * vector());
    }
    return mesh;
}

class PaperContactTest : public GlTest {};

TEST_F(PaperContactTest, AgreesWithTheReference) {
    for (unsigned seed = kSeed; seed < kSeed + 4; ++seed) {
        Pieces pieces(shakenCluster(seed));
        ASSERT_EQ(pieces.model.pieces.size(), 3u);
        BodyState expected = pieces.state;
        const BodyState before = expected;
        const shared::ContactUniforms uniforms =
            paperContactUniforms(pieces.settings, contactEdgeLength(pieces.model));
        const int pairs = respondAsThePaper(pieces.model, uniforms, expected);
        EXPECT_EQ(pieces.respond(), pairs) << "seed " << seed;
        EXPECT_GT(pairs, 100);
        int moved = 0;
        for (std::size_t v = 0; v < expected.positions.size(); ++v) {
            EXPECT_LT((pieces.state.positions[v] - expected.positions[v]).norm(), 1e-6f) << v;
            EXPECT_LT((pieces.state.velocities[v] - expected.velocities[v]).norm(), 2e-4f) << v;
            moved += expected.positions[v] != before.positions[v];
        }
        EXPECT_GT(moved, 50);
    }
}

TEST_F(PaperContactTest, WhatApproachesLosesItsRelativeSpeed) {
    const Blocks blocks(-2);
    Pieces pieces(blocks.mesh);
    EXPECT_GT(pieces.respond(), 20);
    int changed = 0;
    for (int v = 0; v < blocks.mesh.vertexCount(); ++v) {
        const double before = blocks.mesh.velocity(v).y();
        const double after = pieces.state.velocities[v].y();
        if (after != before) {
            ++changed;
            EXPECT_NEAR(after, -1, 1e-4) << v << ": the mean of both";
        }
    }
    EXPECT_GT(changed, 10);
}

TEST_F(PaperContactTest, WhatPartsKeepsItsSpeed) {
    const Blocks blocks(1);
    Pieces pieces(blocks.mesh);
    EXPECT_GT(pieces.respond(), 20);
    for (int v = 0; v < blocks.mesh.vertexCount(); ++v) {
        EXPECT_EQ(pieces.state.velocities[v], blocks.mesh.velocity(v).cast<float>());
    }
}

// The halves of a cut that fell onto each other must not stay one.
TEST_F(PaperContactTest, WhatOverlapsAtRestComesApart) {
    const Blocks blocks(0);
    Simulation simulation(blocks.mesh, publishedParams());
    int steps = 0;
    while (simulation.step().contacts > 0 && ++steps < 100) {
    }
    EXPECT_GT(steps, 0);
    EXPECT_LT(steps, 100);
    const std::vector<Bounds>& boxes = simulation.pieceBounds();
    const double gap =
        std::max(boxes[0].low.y() - boxes[1].high.y(), boxes[1].low.y() - boxes[0].high.y());
    EXPECT_GT(gap, -1e-3);
    EXPECT_LT(gap, 0.02) << "they are not shot apart";
}

TEST_F(PaperContactTest, NoPushIsLongerThanTheDepenetrationSpeedAllows) {
    const Blocks blocks(0);
    Pieces pieces(blocks.mesh);
    const BodyState before = pieces.state;
    pieces.respond();
    const double most = 0.5 * publishedParams().depenetrationSpeed * publishedParams().timeStep;
    double longest = 0;
    for (std::size_t v = 0; v < before.positions.size(); ++v) {
        longest =
            std::max<double>(longest, (pieces.state.positions[v] - before.positions[v]).norm());
    }
    EXPECT_LE(longest, most * (1 + 1e-4)) << "however many triangles push";
    EXPECT_GT(longest, 0.5 * most);
}

TEST_F(PaperContactTest, WhatLiesApartIsLeft) {
    Blocks blocks(-2);
    for (int v = blocks.firstOfUpper; v < blocks.mesh.vertexCount(); ++v) {
        blocks.mesh.setPosition(v, blocks.mesh.position(v) + Vec3(0, 0.03, 0));
    }
    Pieces pieces(blocks.mesh);
    const BodyState before = pieces.state;
    EXPECT_EQ(pieces.respond(), 0);
    EXPECT_EQ(pieces.state.positions, before.positions);
    EXPECT_EQ(pieces.state.velocities, before.velocities);
}

TEST_F(PaperContactTest, WhatIsPinnedStays) {
    const Blocks blocks(-2);
    Pieces pieces(blocks.mesh);
    std::vector<std::uint32_t> all(pieces.state.positions.size());
    std::iota(all.begin(), all.end(), 0u);
    pieces.gpu.masses().setPinned(all);
    const BodyState before = pieces.state;
    pieces.gpu.predictAndStretch();  // pins take effect with a substep
    EXPECT_GT(pieces.respond(), 20);
    EXPECT_EQ(pieces.state.positions, before.positions);
}

TEST_F(PaperContactTest, ReplacesContactWhereItIsAskedForAndReadsNothingBack) {
    Params params = publishedParams();
    params.paperContact = 0;
    Simulation simulation(Blocks(-2).mesh, params);
    ASSERT_EQ(simulation.execute(SetParam{"paper_contact", 1.0}), "");
    const int reads = simulation.wholeReads();
    EXPECT_GT(simulation.step().contacts, 20);
    simulation.step();
    EXPECT_EQ(simulation.wholeReads(), reads);
    ASSERT_EQ(simulation.execute(SetParam{"paper_contact", 0.0}), "");
    ASSERT_EQ(simulation.execute(SetParam{"contact", 0.0}), "");
    EXPECT_EQ(simulation.step().contacts, 0);
}

}  // namespace
}  // namespace kerf
