#include "sim/cut/commit/commit.h"

namespace kerf::cut {
namespace {

constexpr double kRounding = 1e-12;

/// What a committed step must have left of the mesh as it was.
struct Committed {
    const SurfaceMesh& before;
    const SurfaceMesh& after;
    const StepPlan& plan;
    const CommitResult& result;
    /// Edges with the same ends were split: that makes triangles and vertices of its own.
    bool wasRepaired() const { return result.delta.addedTriangles.size() > plan.triangles.size(); }
};

void expectClosedBody(const Committed& c) {
    EXPECT_EQ(checkClosedManifold(c.after), "");
    EXPECT_NEAR(meshVolume(c.after), meshVolume(c.before), kRounding);
    EXPECT_NEAR(meshRestVolume(c.after), meshRestVolume(c.before), kRounding);
}

void expectDeltaNamesWhatChanged(const Committed& c) {
    const CutDelta& delta = c.result.delta;
    EXPECT_EQ(delta.removedTriangles, c.plan.subdivision.replaced);
    std::vector<int> changed;
    for (const int t : livingTriangles(c.before)) {
        if (std::ranges::binary_search(delta.removedTriangles, t)) {
            EXPECT_FALSE(c.after.alive(t));
            continue;
        }
        EXPECT_EQ(c.after.kind(t), c.before.kind(t));
        EXPECT_EQ(c.after.wallLabel(t), c.before.wallLabel(t));
        if (c.after.triangle(t) != c.before.triangle(t)) {
            changed.push_back(t);
        }
    }
    EXPECT_EQ(delta.changedTriangles, changed);
    std::vector<int> added;
    for (int t = c.before.triangleSlots(); t < c.after.triangleSlots(); ++t) {
        added.push_back(t);
        EXPECT_TRUE(c.after.alive(t));
    }
    EXPECT_EQ(delta.addedTriangles, added);
    EXPECT_TRUE(delta.movedVertices.empty());
    EXPECT_TRUE(delta.deadVertices.empty());
}

/// Beside what did not go, edges keep their twins.
void expectTwinsStay(const Committed& c) {
    const std::vector<int> touched = changedTriangles(c.result.delta);
    const auto isTouched = [&](int h) { return std::ranges::binary_search(touched, h / 3); };
    for (const int t : livingTriangles(c.before)) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (!isTouched(h) && !isTouched(c.before.twin(h)) &&
                c.after.twin(h) < 3 * c.before.triangleSlots()) {
                EXPECT_EQ(c.after.twin(h), c.before.twin(h));
            }
        }
    }
}

void expectOldVerticesStay(const Committed& c) {
    EXPECT_EQ(c.result.delta.firstNewVertex, c.before.vertexCount());
    for (int v = 0; v < c.before.vertexCount(); ++v) {
        EXPECT_EQ(c.after.position(v), c.before.position(v));
        EXPECT_EQ(c.after.restPosition(v), c.before.restPosition(v));
        EXPECT_EQ(c.after.velocity(v), c.before.velocity(v));
        EXPECT_EQ(c.after.outgoing(v) >= 0, c.before.outgoing(v) >= 0) << "the first keeps it";
    }
}

/// Each corner is the vertex of the plan or one of its copies, or a new vertex for a node.
void expectIsThePlan(const Committed& c) {
    const int first = c.before.triangleSlots();
    for (int t = 0; t < sizeOf(c.plan.triangles) && !c.wasRepaired(); ++t) {
        const NewTriangle& planned = c.plan.triangles[t];
        EXPECT_EQ(c.after.kind(first + t), planned.kind);
        EXPECT_EQ(c.after.wallLabel(first + t), planned.wallLabel);
        for (int i = 0; i < 3; ++i) {
            const int v = c.after.triangle(first + t)[i];
            const int node = planned.corners[i] - c.before.vertexCount();
            if (node < 0) {
                EXPECT_EQ(c.after.firstCopy(v), c.after.firstCopy(planned.corners[i]));
            } else {
                EXPECT_EQ(c.after.position(v), c.plan.curves.nodes[node].position);
                EXPECT_EQ(c.after.restPosition(v), c.plan.curves.nodes[node].rest);
                EXPECT_EQ(c.after.velocity(v), c.plan.curves.nodes[node].velocity);
            }
        }
    }
}

/// Copies are of one point, and nodes become vertices where they lie.
void expectCopies(const Committed& c) {
    for (int v = 0; v < c.after.vertexCount(); ++v) {
        const int first = c.after.firstCopy(v);
        EXPECT_LT((c.after.position(v) - c.after.position(first)).norm(), kRounding);
        EXPECT_LT((c.after.restPosition(v) - c.after.restPosition(first)).norm(), kRounding);
    }
    const std::vector<CutNode>& nodes = c.plan.curves.nodes;
    const auto made = std::ranges::count_if(
        nodes, [](const CutNode& node) { return node.kind != NodeKind::vertex; });
    if (!c.wasRepaired()) {
        EXPECT_EQ(c.after.vertexCount(), c.before.vertexCount() + made + c.result.splitVertices);
    }
}

void expectRung(const Committed& c) {
    const std::vector<RungNode>& rung = c.result.rung;
    EXPECT_EQ(checkFront(c.after, rung), "");
    EXPECT_EQ(rung.front().vertex < 0, !c.plan.outline.endAInside);
    EXPECT_EQ(rung.back().vertex < 0, !c.plan.outline.endBInside);
    for (int i = 0; i < sizeOf(rung); ++i) {
        EXPECT_TRUE(rung[i].vertex < 0 || rung[i].position == c.after.position(rung[i].vertex));
        EXPECT_TRUE(i == 0 || rung[i].s >= rung[i - 1].s);
    }
    const auto attached = [](const auto& points) {
        return std::ranges::count_if(points, [](const auto& point) { return point.attached; });
    };
    EXPECT_EQ(attached(rung), attached(c.plan.outline.front));
}

void expectCommitted(const Committed& c) {
    expectClosedBody(c);
    expectDeltaNamesWhatChanged(c);
    expectTwinsStay(c);
    expectIsThePlan(c);
    expectOldVerticesStay(c);
    expectCopies(c);
    expectRung(c);
}

/// Plans a step to `to`, carries it out, and holds it against its promises.
CommitResult checkedStep(StepBench& bench, const Blade& to) {
    const SurfaceMesh before = bench.mesh;
    const PlannedStep step = planStep(bench.stepTo(to));
    CommitResult result = bench.carryOut(step);
    expectCommitted({before, bench.mesh, step.plan, result});
    return result;
}

TEST(Commit, OfTheTopOfATetrahedronLeavesTwoPieces) {
    StepBench bench(unitTetrahedron(), 1);
    bench.begin(bladeAt(2, 0.25));
    const CommitResult result = checkedStep(bench, bladeAt(-8, 0.25));
    EXPECT_EQ(bench.mesh.vertexCount(), 4 + 2 * 3) << "two copies of each node";
    EXPECT_EQ(result.splitVertices, 3);
    EXPECT_EQ(bench.mesh.aliveTriangles(), 1 + 3 * 3 + 2);
    const PieceMap pieces = findPieces(bench.mesh);
    ASSERT_EQ(pieces.pieces.size(), 2U);
    EXPECT_NEAR(pieces.pieces[1].volume, 0.75 * 0.75 * 0.75 / 6, 1e-15) << "the top";
}

TEST(Commit, OpensTheOldFrontAndLeavesTheNewOneClosed) {
    StepBench bench(box(), 0.25);
    bench.begin(bladeAt(1, 0.1));
    checkedStep(bench, bladeAt(-0.2, 0.1));
    const std::vector<RungNode> old = bench.rung();
    checkedStep(bench, bladeAt(-0.4, 0.1));
    for (std::size_t i = 1; i + 1 < old.size(); ++i) {
        EXPECT_GE(bench.mesh.copyGroup(old[i].vertex), 0);
    }
    const std::vector<RungNode>& now = bench.rung();
    for (std::size_t i = 1; i + 1 < now.size(); ++i) {
        EXPECT_LT(bench.mesh.copyGroup(now[i].vertex), 0);
    }
    EXPECT_EQ(slitEdges(bench.mesh, 0), 4);
    EXPECT_EQ(checkMirroredWalls(bench.mesh), "");
}

// The blade turns about its end in the air, with its tip inside. Its mouth is one edge long: both
// lips would be edges between the same two vertices.
TEST(Commit, SplitsEdgesWithTheSameEnds) {
    StepBench bench(unitTetrahedron(), 1);
    bench.begin({{0.2, -2, 0.25}, {0.2, 0.2, 0.25}});
    const SurfaceMesh before = bench.mesh;
    const PlannedStep step = planStep(bench.stepTo({{0.2, -2, 0.25}, {0.4, 0.2, 0.25}}));
    const CommitResult result = bench.carryOut(step);
    const Committed committed{before, bench.mesh, step.plan, result};
    EXPECT_TRUE(committed.wasRepaired());
    expectCommitted(committed);
    EXPECT_EQ(checkMirroredWalls(bench.mesh), "");
}

TEST(Commit, GivesWallsTheirStrokeAndSide) {
    StepBench bench(box(), 0.3);
    for (int stroke = 0; stroke < 3; ++stroke) {
        const double z = -0.2 + 0.2 * stroke;
        const int first = bench.mesh.triangleSlots();
        bench.begin(bladeAt(1, z));
        checkedStep(bench, bladeAt(-1, z));
        std::set<int> labels;
        for (int t = first; t < bench.mesh.triangleSlots(); ++t) {
            labels.insert(bench.mesh.wallLabel(t));
        }
        EXPECT_EQ(labels, (std::set<int>{-1, 2 * stroke, 2 * stroke + 1}));
    }
    EXPECT_EQ(findPieces(bench.mesh).pieces.size(), 4U);
}

// Four copies where two walls cross.
TEST(Commit, JoinsTheCopiesOfBothWallsThatItCrosses) {
    StepBench bench(box(), 0.3);
    bench.begin(bladeAt(1, 0.1));
    checkedStep(bench, bladeAt(-1, 0.1));
    bench.begin({{0.07, 1, -2}, {0.07, 1, 2}});
    checkedStep(bench, {{0.07, -1, -2}, {0.07, -1, 2}});
    int ofFour = 0;
    for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
        const bool first = bench.mesh.firstCopy(v) == v && bench.mesh.copyGroup(v) >= 0;
        const Vec3& p = bench.mesh.position(v);
        if (first && std::fabs(p.x() - 0.07) < 1e-9 && std::fabs(p.z() - 0.1) < 1e-9) {
            EXPECT_EQ(bench.mesh.copiesOfGroup(bench.mesh.copyGroup(v)).size(), 4U);
            ++ofFour;
        }
    }
    EXPECT_GT(ofFour, 2);
    EXPECT_EQ(findPieces(bench.mesh).pieces.size(), 4U);
    EXPECT_EQ(checkMirroredWalls(bench.mesh), "");
}

// Both halves have slid along each other: the front leaves and enters walls that are no mirrors.
TEST(Commit, JoinsTheFrontAcrossAnOlderSlit) {
    StepBench bench(box(), 0.3);
    bench.begin(bladeAt(1, 0.1));
    bench.cutTo(bladeAt(-1, 0.1));
    const PieceMap pieces = findPieces(bench.mesh);
    for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
        const double slid = 0.08 * pieces.ofVertex[v];
        bench.mesh.setPosition(v, bench.mesh.position(v) + Vec3(slid, 0.5 * slid, 0));
    }
    bench.begin({{0.07, 1, -2}, {0.07, 1, 2}});
    const std::vector<RungNode> rung = bench.cutTo({{0.07, 0.03, -2}, {0.07, 0.03, 2}}).rung;
    const auto leaves = std::ranges::find_if(rung, [](const RungNode& node) {
        return node.vertex >= 0 && !node.attached && std::fabs(node.position.z() - 0.1) < 1e-9;
    });
    ASSERT_NE(leaves, rung.end());
    EXPECT_NE(leaves->vertex, (leaves + 1)->vertex);
    EXPECT_EQ(bench.mesh.firstCopy(leaves->vertex), bench.mesh.firstCopy((leaves + 1)->vertex));
}

TEST(Commit, OfRandomStepsLeavesAClosedBodyAndTellsAll) {
    const std::uint32_t seed = fuzzSeed(61);
    SCOPED_TRACE("seed " + std::to_string(seed));
    int repaired = 0;
    int crossed = 0;
    const int steps = forRandomSteps(seed, 80, [&](const StepInput& in, const PlannedStep& step) {
        SurfaceMesh mesh = in.mesh;
        const CommitResult result = commit(mesh, step.plan, in.h, in.stroke, {});
        const Committed committed{in.mesh, mesh, step.plan, result};
        expectCommitted(committed);
        repaired += committed.wasRepaired();
        crossed += std::ranges::any_of(result.delta.removedTriangles,
                                       [&](int t) { return in.mesh.kind(t) == SurfaceKind::wall; });
    });
    EXPECT_GT(steps, 130);
    EXPECT_GT(repaired, 0);
    EXPECT_GT(crossed, 20) << "older walls";
}

}  // namespace
}  // namespace kerf::cut
