#include "sim/mesh/triangle_tree.h"

namespace kerf {
namespace {

Bounds boundsOf(const SurfaceMesh& mesh, int t) {
    Bounds bounds;
    for (const int v : mesh.triangle(t)) {
        bounds.add(mesh.position(v));
    }
    return bounds;
}

Bounds cube(const Vec3& center, double size) {
    Bounds box;
    box.add(center);
    box.widen(0.5 * size);
    return box;
}

/// What lies in the box is found, all of it, and not everything else besides.
void expectFinds(TriangleTree& tree, const SurfaceMesh& mesh, const Bounds& box) {
    const std::vector<int> found = tree.find([&](const Bounds& b) { return b.overlaps(box); });
    int within = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t) && boundsOf(mesh, t).overlaps(box)) {
            EXPECT_TRUE(std::binary_search(found.begin(), found.end(), t)) << t;
            ++within;
        }
    }
    EXPECT_LE(found.size(), 10u * within + 100u);
    for (const int t : found) {
        EXPECT_TRUE(mesh.alive(t));
    }
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
}

class TriangleTreeTest : public testing::Test {
  protected:
    static constexpr unsigned kSeed = 3;
    std::mt19937 random{kSeed};
    std::uniform_real_distribution<double> uniform{-0.5, 0.5};

    Vec3 point() { return {uniform(random), uniform(random), uniform(random)}; }
    void expectFindsAnywhere(TriangleTree& tree, const SurfaceMesh& mesh) {
        for (int i = 0; i < 10; ++i) {
            SCOPED_TRACE("seed " + std::to_string(kSeed));
            expectFinds(tree, mesh, cube(point(), 0.2));
        }
    }
};

TEST_F(TriangleTreeTest, FindsWhatLiesInABox) {
    const SurfaceMesh mesh = icosphere(4);
    TriangleTree tree(mesh);
    expectFindsAnywhere(tree, mesh);
}

TEST_F(TriangleTreeTest, FollowsABodyThatMovesWithinTheBoundPromised) {
    SurfaceMesh mesh = icosphere(4);
    TriangleTree tree(mesh);
    const Vec3 drift = 0.004 * point();
    for (int step = 0; step < 200; ++step) {
        double most = 0;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const Vec3 move = drift + 0.01 * point();
            most = std::max(most, move.norm());
            mesh.setPosition(v, mesh.position(v) + move);
        }
        tree.moved(most);
        expectFinds(tree, mesh, cube(mesh.position(step), 0.1));
    }
}

TEST_F(TriangleTreeTest, FindsAnewWhereTheBodyMovedAnyhow) {
    SurfaceMesh mesh = icosphere(3);
    TriangleTree tree(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) + Vec3(7, 0, 0));
    }
    tree.movedAnyhow();
    expectFinds(tree, mesh, cube({7.5, 0, 0}, 0.3));
}

TEST_F(TriangleTreeTest, FollowsCuts) {
    SurfaceMesh mesh = icosphere(3);
    TriangleTree tree(mesh);
    for (const Vec3& along : {Vec3(1, 0.1, 0.2), Vec3(0.1, 0.3, 1), Vec3(0.7, -0.6, 0.2)}) {
        Cutter cutter(mesh, exactSettings());
        const Vec3 travel = along.cross(Vec3(0.3, 1, -0.4)).normalized();
        const Stroke blades = straightStroke(0.1 * point(), along.normalized(), travel, 3, 1.6, 30);
        eachStep(cutter, blades,
                 [&](const CutResult& result) { tree.update(changedTriangles(result.delta)); });
        expectFindsAnywhere(tree, mesh);
    }
    EXPECT_GT(mesh.aliveTriangles(), 3000);
}

TEST_F(TriangleTreeTest, StaysShallowWhenThingsAreAddedInARow) {
    std::vector<Bounds> boxes;
    const auto boundsOfId = [&](int id) { return boxes[id]; };
    BoxTree tree;
    for (int id = 0; id < 20000; ++id) {
        boxes.push_back(cube(Vec3(id, 0, 0), 1.5));
        tree.insert(std::array{id}, boundsOfId);
    }
    for (int id = 0; id < 19000; ++id) {
        tree.erase(std::array{id});
    }
    std::vector<int> found;
    tree.find(
        boundsOfId, [&](const Bounds& b) { return b.overlaps(cube(Vec3(19500, 0, 0), 1)); },
        [&](int id) { found.push_back(id); });
    EXPECT_TRUE(std::find(found.begin(), found.end(), 19500) != found.end());
    EXPECT_LT(found.size(), 40u);
    std::vector<std::array<int, 2>> stack;  // nodes and how deep they lie
    for (const int root : tree.roots()) {
        stack.push_back({root, 0});
    }
    int deepest = 0;
    while (!stack.empty()) {
        const auto [index, depth] = stack.back();
        stack.pop_back();
        deepest = std::max(deepest, depth);
        if (const int child = tree.childrenOf(index); child >= 0) {
            stack.insert(stack.end(), {{child, depth + 1}, {child + 1, depth + 1}});
        }
    }
    EXPECT_LE(deepest, BoxTree::kMaxDepth);
}

TEST_F(TriangleTreeTest, WhatWasBuiltAtOnceCanBeEdited) {
    const auto boundsOfId = [](int id) { return cube(Vec3(id, 0, 0), 0.4); };
    std::vector<int> ids(100);
    std::iota(ids.begin(), ids.end(), 0);
    BoxTree tree(ids, boundsOfId);
    for (int id = 0; id < 100; id += 2) {
        tree.erase(std::array{id});
    }
    tree.insert(std::array{4}, boundsOfId);
    std::vector<int> found;
    tree.find(
        boundsOfId, [](const Bounds&) { return true; }, [&](int id) { found.push_back(id); });
    std::ranges::sort(found);
    EXPECT_EQ(found.size(), 51u);
    for (int id = 0; id < 100; ++id) {
        EXPECT_EQ(std::ranges::binary_search(found, id), id % 2 == 1 || id == 4) << id;
    }
}

/// Random boxes of which some come and go: what is found is what a look at all of them finds.
class BoxTreeTest : public testing::TestWithParam<BoxTree::Joining> {
  protected:
    static constexpr unsigned kSeed = 5;
    std::mt19937 random{kSeed};
    std::uniform_real_distribution<double> uniform{-1, 1};
    std::vector<Bounds> boxes;
    std::vector<bool> inTree;
    BoxTree tree{GetParam()};
    BoxTree::BoundsOf boundsOfId = [this](int id) { return boxes[id]; };

    // Sizes from a thousandth up to a half, many in one place.
    Bounds box() {
        const Vec3 center = uniform(random) > 0.8
                                ? Vec3(Vec3::Constant(0.3))
                                : Vec3(uniform(random), uniform(random), uniform(random));
        return cube(center, std::pow(10, -1.65 + 1.35 * uniform(random)));
    }

    void add(int count) {
        std::vector<int> ids;
        for (int i = 0; i < count; ++i) {
            ids.push_back(static_cast<int>(boxes.size()));
            boxes.push_back(box());
            inTree.push_back(true);
        }
        tree.insert(ids, boundsOfId);
    }

    void eraseSome(double share) {
        std::vector<int> ids;
        for (int id = 0; id < static_cast<int>(boxes.size()); ++id) {
            if (std::fabs(uniform(random)) < share) {
                ids.push_back(id);
                inTree[id] = false;
            }
        }
        tree.erase(ids);
    }

    void expectFindsAll() {
        SCOPED_TRACE("seed " + std::to_string(kSeed));
        const Bounds searched = cube(Vec3(uniform(random), uniform(random), uniform(random)), 0.3);
        std::vector<int> found;
        tree.find(
            boundsOfId, [&](const Bounds& b) { return b.overlaps(searched); },
            [&](int id) { found.push_back(id); });
        std::ranges::sort(found);
        EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
        int count = 0;
        for (int id = 0; id < static_cast<int>(boxes.size()); ++id) {
            EXPECT_EQ(tree.contains(id), inTree[id]);
            count += inTree[id];
            if (inTree[id] && boxes[id].overlaps(searched)) {
                EXPECT_TRUE(std::ranges::binary_search(found, id)) << id;
            }
        }
        EXPECT_TRUE(std::ranges::all_of(found, [this](int id) { return inTree[id]; }));
        int counted = 0;
        for (const int root : tree.roots()) {
            counted += tree.node(root).count;
        }
        EXPECT_EQ(counted, count);
    }
};

TEST_P(BoxTreeTest, FindsAllWhileThingsComeAndGo) {
    add(3000);
    for (int round = 0; round < 60; ++round) {
        expectFindsAll();
        add(1 + static_cast<int>(random() % 300));
        expectFindsAll();
        eraseSome(round % 7 == 0 ? 0.6 : 0.02);
        EXPECT_LE(tree.roots().size(), 20u);
    }
    eraseSome(2);
    expectFindsAll();
    EXPECT_TRUE(tree.bounds().empty());
    add(10);
    expectFindsAll();
}

TEST_P(BoxTreeTest, FindsAllWhileThingsMove) {
    add(2000);
    for (int round = 0; round < 60; ++round) {
        const double most = 0.01;
        for (Bounds& moving : boxes) {
            const Vec3 way = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
            moving.low += most * way;
            moving.high += most * way;
        }
        tree.moved(most);
        expectFindsAll();
        add(20);
        eraseSome(0.01);
    }
}

TEST_P(BoxTreeTest, HoldsWhatLiesWhereItLay) {
    add(500);
    tree.divideAll();
    boxes[3] = cube(boxes[3].center() + Vec3(1e-3, 0, 0), 0.1);
    EXPECT_FALSE(tree.holds(3, boxes[3]));
    EXPECT_TRUE(tree.holds(4, boxes[4]));
    tree.erase(std::vector<int>{4});
    EXPECT_FALSE(tree.holds(4, boxes[4]));
    tree.insert(std::vector<int>{4}, boundsOfId);
    EXPECT_TRUE(tree.holds(4, boxes[4]));
}

TEST_P(BoxTreeTest, FindsTheSameHoweverMuchIsDivided) {
    add(2000);
    BoxTree divided = tree;
    divided.divideAll();
    int leaves = 0;
    std::vector<int> stack = divided.roots();
    while (!stack.empty()) {
        const BoxTree::Node& node = divided.node(stack.back());
        stack.pop_back();
        EXPECT_LE(node.depth, BoxTree::kMaxDepth);
        if (node.child >= 0) {
            stack.insert(stack.end(), {node.child, node.child + 1});
        } else {
            ++leaves;
            EXPECT_LE(node.count, 8);
        }
    }
    EXPECT_GE(leaves, 250);
    for (int i = 0; i < 20; ++i) {
        const Bounds searched = cube(Vec3(uniform(random), uniform(random), uniform(random)), 0.3);
        std::array<std::vector<int>, 2> found;
        for (int k = 0; k < 2; ++k) {
            (k == 0 ? tree : divided)
                .find(
                    boundsOfId, [&](const Bounds& b) { return b.overlaps(searched); },
                    [&](int id) { found[k].push_back(id); });
        }
        EXPECT_EQ(found[0], found[1]);
    }
}

INSTANTIATE_TEST_SUITE_P(Joinings, BoxTreeTest,
                         testing::Values(BoxTree::Joining::anew, BoxTree::Joining::divided));

}  // namespace
}  // namespace kerf
