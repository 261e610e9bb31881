#include "sim/cut/plan/glue.h"

namespace kerf::cut {
namespace {

/// The new triangles of a plan, and what their half-edges are glued to.
class Glued {
  public:
    Glued(const SurfaceMesh& mesh, const StepPlan& plan, std::vector<GluePartner> partners)
        : mesh_(mesh), plan_(plan), partners_(std::move(partners)) {
        for (const OutlineEdge& edge : plan.outline.edges) {
            kinds_[{cornerId(mesh, plan.curves, edge.from), cornerId(mesh, plan.curves, edge.to)}] =
                edge.kind;
        }
    }

    int count() const { return sizeOf(partners_); }
    GluePartner partner(int h) const { return partners_[h]; }
    CutSide side(int h) const { return plan_.triangles[h / 3].side; }
    std::pair<int, int> ends(int h) const {
        const Triangle& c = plan_.triangles[h / 3].corners;
        return {c[h % 3], c[(h + 1) % 3]};
    }
    /// Of the outline edge that runs as h does, or the other way.
    const OutlineKind* along(int h) const { return kindOf(ends(h)); }
    const OutlineKind* against(int h) const { return kindOf({ends(h).second, ends(h).first}); }

    std::pair<int, int> endsOfPartner(int h) const {
        const GluePartner& other = partners_[h];
        return other.newHalfEdge >= 0
                   ? ends(other.newHalfEdge)
                   : std::pair{mesh_.origin(other.meshHalfEdge), mesh_.target(other.meshHalfEdge)};
    }

  private:
    const OutlineKind* kindOf(const std::pair<int, int>& edge) const {
        const auto found = kinds_.find(edge);
        return found == kinds_.end() ? nullptr : &found->second;
    }

    const SurfaceMesh& mesh_;
    const StepPlan& plan_;
    std::vector<GluePartner> partners_;
    std::map<std::pair<int, int>, OutlineKind> kinds_;
};

Glued gluedOf(const SurfaceMesh& mesh, const StepPlan& plan) {
    return {mesh, plan, glue(mesh, plan.curves, plan.outline, plan.subdivision, plan.triangles)};
}

/// Each half-edge has one partner, which runs the other way between the same corners.
void expectMutual(const Glued& glued) {
    for (int h = 0; h < glued.count(); ++h) {
        const GluePartner& other = glued.partner(h);
        ASSERT_NE(other.newHalfEdge >= 0, other.meshHalfEdge >= 0) << "one partner, not two";
        EXPECT_EQ(glued.endsOfPartner(h), std::pair(glued.ends(h).second, glued.ends(h).first));
        if (other.newHalfEdge >= 0) {
            EXPECT_EQ(glued.partner(other.newHalfEdge).newHalfEdge, h);
        }
    }
}

/// Those of the mesh that stay beside what goes, and the old front's, each once.
void expectAllOfTheMesh(const SurfaceMesh& mesh, const StepPlan& plan, const Glued& glued) {
    std::set<int> wanted;
    const std::vector<int>& replaced = plan.subdivision.replaced;
    const auto goes = [&](int h) { return std::ranges::binary_search(replaced, h / 3); };
    const auto isFront = [&](int h) {
        return std::ranges::any_of(plan.outline.edges, [&](const OutlineEdge& edge) {
            return edge.kind == OutlineKind::front &&
                   edgeOf(plan.curves.nodes[edge.from].a, plan.curves.nodes[edge.to].a) ==
                       edgeOf(mesh.origin(h), mesh.target(h));
        });
    };
    for (const int t : livingTriangles(mesh)) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (!goes(h) && (goes(mesh.twin(h)) || isFront(h))) {
                wanted.insert(h);
            }
        }
    }
    std::set<int> found;
    for (int h = 0; h < glued.count(); ++h) {
        const int old = glued.partner(h).meshHalfEdge;
        EXPECT_TRUE(old < 0 || found.insert(old).second) << "twice";
    }
    EXPECT_EQ(found, wanted);
}

/// The side of the partner; that of the surface where the partner is of the mesh.
CutSide sideOfPartner(const Glued& glued, int h) {
    const int other = glued.partner(h).newHalfEdge;
    return other < 0 ? CutSide::surface : glued.side(other);
}

/// W- runs along the outline, W+ against it. What else is of one side stays on it.
CutSide wantedSide(const Glued& glued, int h) {
    const CutSide own = glued.side(h);
    if (own == CutSide::surface) {
        const OutlineKind* along = glued.along(h);
        const OutlineKind* against = glued.against(h);
        const auto opens = [](const OutlineKind* kind) {
            return kind != nullptr && *kind != OutlineKind::free;
        };
        return opens(along) ? CutSide::plus : opens(against) ? CutSide::minus : own;
    }
    const OutlineKind* kind = own == CutSide::minus ? glued.along(h) : glued.against(h);
    if (kind == nullptr) {
        return own;
    }
    const CutSide other = own == CutSide::minus ? CutSide::plus : CutSide::minus;
    return *kind == OutlineKind::free ? other : CutSide::surface;
}

void expectSides(const Glued& glued) {
    for (int h = 0; h < glued.count(); ++h) {
        EXPECT_EQ(sideOfPartner(glued, h), wantedSide(glued, h)) << "half-edge " << h;
    }
}

void expectGlued(const SurfaceMesh& mesh, const StepPlan& plan) {
    const Glued glued = gluedOf(mesh, plan);
    ASSERT_EQ(glued.count(), 3 * sizeOf(plan.triangles));
    expectMutual(glued);
    expectAllOfTheMesh(mesh, plan, glued);
    expectSides(glued);
}

/// The top of a tetrahedron, cut off by one triangle; h is larger than all of it.
class GlueTheTop : public ::testing::Test {
  protected:
    GlueTheTop() {
        bench.begin(bladeAt(2, 0.25));
        plan = planStep(bench.stepTo(bladeAt(-8, 0.25))).plan;
    }
    std::string reason() const {
        return reasonOf(
            [&] { glue(bench.mesh, plan.curves, plan.outline, plan.subdivision, plan.triangles); });
    }

    StepBench bench{unitTetrahedron(), 1};
    StepPlan plan;
};

TEST_F(GlueTheTop, JoinsOneWallToTheTopAndOneToTheRest) {
    ASSERT_EQ(plan.triangles.size(), 3U * 3 + 2);
    expectGlued(bench.mesh, plan);
    const Glued glued = gluedOf(bench.mesh, plan);
    const auto besideTop = [&](int h) {
        const Triangle& beside = plan.triangles[glued.partner(h).newHalfEdge / 3].corners;
        return std::ranges::count(beside, 3) > 0;
    };
    // The normal of the strip points down, and W+ lies on the side of it.
    for (int e = 0; e < 3; ++e) {
        EXPECT_FALSE(besideTop(3 * 9 + e)) << "W+";
        EXPECT_TRUE(besideTop(3 * 10 + e)) << "W-";
    }
}

TEST_F(GlueTheTop, LeavesTheBottomAsItIs) {
    const Glued glued = gluedOf(bench.mesh, plan);
    std::set<int> ofBottom;
    for (int h = 0; h < glued.count(); ++h) {
        if (glued.partner(h).meshHalfEdge >= 0) {
            ofBottom.insert(glued.partner(h).meshHalfEdge);
        }
    }
    EXPECT_EQ(ofBottom, (std::set<int>{0, 1, 2}));
}

TEST_F(GlueTheTop, RefusesPlansWithoutOnePartnerForEachHalfEdge) {
    const StepPlan whole = plan;
    plan.triangles[1].corners = plan.triangles[0].corners;
    EXPECT_EQ(reason(), "two new triangles share a directed edge");
    plan = whole;
    plan.outline.edges.pop_back();
    EXPECT_EQ(reason(), "a new half-edge has no partner");
    plan = whole;
    plan.subdivision.replaced.insert(plan.subdivision.replaced.begin(), 0);
    EXPECT_EQ(reason(), "a new half-edge has no partner in the mesh");
    plan = whole;
    plan.outline.edges.front().kind = OutlineKind::front;
    EXPECT_EQ(reason(), "the gluing is not mutual");
}

TEST(Glue, ClosesTheSlitAlongTheNewFrontAndOpensItAlongTheOld) {
    StepBench bench(box(), 0.25);
    bench.begin(bladeAt(1, 0.1));
    const PlannedStep first = planStep(bench.stepTo(bladeAt(-0.2, 0.1)));
    expectGlued(bench.mesh, first.plan);
    ASSERT_FALSE(HasFailure());
    bench.carryOut(first);
    const StepInput in = bench.stepTo(bladeAt(-0.4, 0.1));
    const StepPlan plan = planStep(in).plan;
    expectGlued(in.mesh, plan);
    const Glued glued = gluedOf(in.mesh, plan);
    int across = 0;
    int ontoOldWalls = 0;
    for (int h = 0; h < glued.count(); ++h) {
        across += glued.side(h) == CutSide::plus && sideOfPartner(glued, h) == CutSide::minus;
        const int old = glued.partner(h).meshHalfEdge;
        ontoOldWalls += glued.side(h) != CutSide::surface && old >= 0 &&
                        in.mesh.kind(old / 3) == SurfaceKind::wall;
    }
    EXPECT_EQ(across, 4);
    EXPECT_EQ(ontoOldWalls, 2 * 4);
}

// As where another slit meets it there.
TEST(Glue, OpensTheOldFrontAlsoWhereTheWallsBehindItAreDivided) {
    StepBench bench(box(), 0.25);
    bench.begin(bladeAt(1, 0.1));
    bench.cutTo(bladeAt(-0.2, 0.1));
    const StepInput in = bench.stepTo(bladeAt(-0.4, 0.1));
    StepPlan plan = planStep(in).plan;
    const auto edge = std::ranges::find(plan.outline.edges, OutlineKind::front, &OutlineEdge::kind);
    const int h =
        in.mesh.findHalfEdge(plan.curves.nodes[edge->from].a, plan.curves.nodes[edge->to].a);
    plan.curves.segmentsOfTriangle[h / 3];
    plan.curves.segmentsOfTriangle[in.mesh.twin(h) / 3];
    const std::vector<NewTriangle> walls(
        plan.triangles.begin() + sizeOf(plan.subdivision.triangles), plan.triangles.end());
    plan.subdivision = subdivide(in.mesh, plan.curves, kCloseNoise * in.h);
    plan.triangles = plan.subdivision.triangles;
    plan.triangles.insert(plan.triangles.end(), walls.begin(), walls.end());
    expectGlued(in.mesh, plan);
}

TEST(Glue, OfRandomStepsLeavesNoHalfEdgeAloneAndNoneAcross) {
    const std::uint32_t seed = fuzzSeed(51);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const int steps = forRandomSteps(seed, 80, [](const StepInput& in, const PlannedStep& step) {
        expectGlued(in.mesh, step.plan);
    });
    EXPECT_GT(steps, 130);
}

}  // namespace
}  // namespace kerf::cut
