#include "sim/contact/paper_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/contact/octree.h"
#include "sim/run/simulation.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

constexpr unsigned kSeed = 5;
constexpr double kTimeStep = 0.005;

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

/// Two blocks of which the upper one stands 2 cm in the lower one.
SurfaceMesh blocksInEachOther(double upperSpeed) {
    const TriangleSoup lower = test::boxSoup({0.6, 0.4, 0.6}, 3);
    SurfaceMesh mesh =
        test::meshOf(test::joined(lower, test::boxSoup({0.5, 0.4, 0.5}, 4), {0.01, 0.38, 0.02}));
    for (int v = static_cast<int>(lower.positions.size()); v < mesh.vertexCount(); ++v) {
        mesh.setVelocity(v, {0, upperSpeed, 0});
    }
    return mesh;
}

TEST(PaperContactTest, WhatMeetsLosesItsRelativeSpeed) {
    const SurfaceMesh mesh = blocksInEachOther(-2);
    const BodyModel model = buildBodyModel(mesh);
    BodyState state = stateOf(mesh);
    EXPECT_GT(respondAsThePaper(model, kTimeStep, state), 20);
    int changed = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double before = mesh.velocity(v).y();
        const double after = state.velocities[v].y();
        if (after != static_cast<float>(before)) {
            ++changed;
            EXPECT_NEAR(after, -1, 1e-6) << v << ": the mean of both";
        }
        EXPECT_NEAR(state.positions[v].y(), mesh.position(v).y() + kTimeStep * (after - before),
                    1e-7);
    }
    EXPECT_GT(changed, 10);
}

// The weakness that the comparison is about.
TEST(PaperContactTest, WhatOverlapsAtRestIsLeft) {
    const SurfaceMesh mesh = blocksInEachOther(0);
    BodyState state = stateOf(mesh);
    const BodyState before = state;
    EXPECT_GT(respondAsThePaper(buildBodyModel(mesh), kTimeStep, state), 20);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        EXPECT_EQ(state.positions[v], before.positions[v]);
    }
}

TEST(PaperContactTest, WhatLiesApartIsLeft) {
    SurfaceMesh mesh = blocksInEachOther(-2);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) + Vec3(0, mesh.velocity(v).y() < 0 ? 0.03 : 0, 0));
    }
    BodyState state = stateOf(mesh);
    EXPECT_EQ(respondAsThePaper(buildBodyModel(mesh), kTimeStep, state), 0);
}

class PaperContactScene : public test::GlTest {};

TEST_F(PaperContactScene, ReplacesContactWhereItIsAskedFor) {
    Params params;
    params.gravity.setZero();
    params.floor.reset();
    Simulation simulation(blocksInEachOther(-2), params);
    ASSERT_EQ(simulation.execute(SetParam{"paper_contact", 1.0}), "");
    EXPECT_GT(simulation.step().contacts, 20);
    ASSERT_EQ(simulation.execute(SetParam{"paper_contact", 0.0}), "");
    ASSERT_EQ(simulation.execute(SetParam{"contact", 0.0}), "");
    EXPECT_EQ(simulation.step().contacts, 0);
}

}  // namespace
}  // namespace kerf
