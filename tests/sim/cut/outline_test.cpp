#include "sim/cut/plan/curves/outline.h"

namespace kerf::cut {
namespace {

constexpr double kOutlineH = 0.25;
constexpr double kNearBorder = 1e-9;

/// Strip, curves and outline of a step, from curves that may have been changed.
struct Traced {
    Strip strip;
    CutCurves curves;
    Outline outline;
};

using Change = std::function<void(Strip& strip, CutCurves& curves)>;

Traced trace(const StepInput& in, const Change& change = {}) {
    PredicatePositions positions(in);
    Traced traced;
    traced.strip = buildStrip(in, positions);
    traced.curves = intersect(in, traced.strip, positions);
    if (change) {
        change(traced.strip, traced.curves);
    }
    const RestGuess guess(in, traced.strip, traced.curves);
    traced.outline = traceOutline(in, traced.strip, guess, traced.curves);
    traced.curves.append(traced.outline.nodes);
    return traced;
}

int countOf(const Outline& outline, OutlineKind kind) {
    return static_cast<int>(std::ranges::count(outline.edges, kind, &OutlineEdge::kind));
}

double areaOf(const Traced& traced) {
    return layoutArea(traced.curves.nodes, traced.outline.edges);
}

/// A box of size 1 about the origin, and a blade in the plane z = 0.1.
class OutlineInABox : public ::testing::Test {
  protected:
    StepBench bench{box(), kOutlineH};

    Traced fromAbove(double to) {
        bench.begin(bladeAt(1, 0.1));
        return trace(bench.stepTo(bladeAt(to, 0.1)));
    }
};

TEST_F(OutlineInABox, OfAFirstStepBoundsWhatTheBladeSweptInside) {
    const Traced traced = fromAbove(-0.2);
    EXPECT_NEAR(areaOf(traced), 0.7, 1e-12);
    EXPECT_EQ(countOf(traced.outline, OutlineKind::cut), sizeOf(traced.curves.segments));
    EXPECT_EQ(countOf(traced.outline, OutlineKind::free), 4) << "of length h on the new rung";
    EXPECT_EQ(countOf(traced.outline, OutlineKind::front), 0);
    EXPECT_FALSE(traced.outline.endAInside || traced.outline.endBInside);
}

TEST_F(OutlineInABox, HasTheNewRungFromBToA) {
    const std::vector<FrontPoint> front = fromAbove(-0.2).outline.front;
    ASSERT_EQ(front.size(), 5U);
    for (int i = 0; i < 5; ++i) {
        EXPECT_NEAR(front[i].s, (2.5 - 0.25 * i) / 4, 1e-12);
        EXPECT_EQ(front[i].attached, i < 4);
    }
}

TEST_F(OutlineInABox, OfANextStepGoesAlongTheOldFront) {
    fromAbove(-0.2);
    bench.cutTo(bladeAt(-0.2, 0.1));
    const Traced traced = trace(bench.stepTo(bladeAt(-0.4, 0.1)));
    EXPECT_NEAR(areaOf(traced), 0.2, 1e-12);
    EXPECT_EQ(countOf(traced.outline, OutlineKind::front), 4);
    EXPECT_EQ(countOf(traced.outline, OutlineKind::free), 4);
}

TEST_F(OutlineInABox, OfAStepRightThroughHasNoFreePiece) {
    const Traced traced = fromAbove(-1);
    EXPECT_NEAR(areaOf(traced), 1, 1e-12);
    EXPECT_EQ(countOf(traced.outline, OutlineKind::cut), sizeOf(traced.outline.edges));
    EXPECT_TRUE(traced.outline.front.empty());
}

TEST_F(OutlineInABox, InTheAirIsEmpty) {
    EXPECT_TRUE(fromAbove(0.6).outline.edges.empty());
}

TEST_F(OutlineInABox, OfABladeWhollyInsideIsEmpty) {
    bench.begin({{-0.3, 0.2, 0.1}, {0.2, 0.2, 0.1}});
    EXPECT_TRUE(trace(bench.stepTo({{-0.3, 0, 0.1}, {0.2, 0, 0.1}})).outline.edges.empty());
}

// From x = -1/2 to 0, and 0.7 deep.
TEST_F(OutlineInABox, FollowsTheTipInside) {
    bench.begin({{-2, 1, 0.1}, {0, 1, 0.1}});
    const Traced traced = trace(bench.stepTo({{-2, -0.2, 0.1}, {0, -0.2, 0.1}}));
    EXPECT_NEAR(areaOf(traced), 0.35, 1e-12);
    EXPECT_TRUE(traced.outline.endBInside);
    EXPECT_FALSE(traced.outline.endAInside);
    EXPECT_EQ(countOf(traced.outline, OutlineKind::free), 2 + 3);
}

// The blade crosses an older slit whose walls have come a little into each other: it enters one
// before it leaves the other.
TEST_F(OutlineInABox, TakesWallsThatPierceEachOtherALittleInTheirOrder) {
    bench.begin(bladeAt(1, 0.1));
    bench.cutTo(bladeAt(-0.3, 0.1));
    SurfaceMesh& mesh = bench.mesh;
    for (const int t : livingTriangles(mesh)) {
        for (const int v : mesh.triangle(t)) {
            if (mesh.kind(t) == SurfaceKind::wall && mesh.copyGroup(v) >= 0) {
                mesh.setPosition(
                    v, mesh.restPosition(v) + Vec3(0, 0, mesh.wallLabel(t) == 0 ? 5e-4 : -5e-4));
            }
        }
    }
    bench.begin({{0.07, 1, -2}, {0.07, 1, 2}});
    const Traced traced = trace(bench.stepTo({{0.07, 0.1, -2}, {0.07, 0.1, 2}}));
    EXPECT_NEAR(areaOf(traced), 0.4, 2e-3);
    EXPECT_EQ(traced.outline.front.size(), 3U + 3U) << "on either side of the slit";
}

TEST_F(OutlineInABox, OfTwoBodiesInOnePlaceIsThatOfEachApart) {
    StepBench both(meshOf(joined(boxSoup(), boxSoup(), {0.3, 0.1, 0.05})), kOutlineH);
    both.begin(bladeAt(1, 0.13));
    const Traced traced = trace(both.stepTo(bladeAt(-0.2, 0.13)));
    std::array<std::vector<OutlineEdge>, 2> ofPiece;
    for (const OutlineEdge& edge : traced.outline.edges) {
        ofPiece.at(edge.piece).push_back(edge);
    }
    EXPECT_NEAR(layoutArea(traced.curves.nodes, ofPiece[0]), 0.7, 1e-12);
    EXPECT_NEAR(layoutArea(traced.curves.nodes, ofPiece[1]), 0.8, 1e-12);
}

/// Contradictions, made by a change of strip or curves.
class OutlineRefuses : public OutlineInABox {
  protected:
    std::string reasonFor(const Change& change) {
        bench.begin(bladeAt(1, 0.1));
        const StepInput in = bench.stepTo(bladeAt(-0.2, 0.1));
        return reasonOf([&] { trace(in, change); });
    }
    std::string reasonBehindFront(const Change& change) {
        bench.begin(bladeAt(1, 0.1));
        bench.cutTo(bladeAt(-0.2, 0.1));
        const StepInput in = bench.stepTo(bladeAt(-0.4, 0.1));
        return reasonOf([&] { trace(in, change); });
    }
    static bool isOnBorder(const Strip& strip, const CutNode& node) {
        return node.kind == NodeKind::face && strip.edges[node.stripEdge].onBorder;
    }
};

TEST_F(OutlineRefuses, NothingThatIsSound) {
    EXPECT_EQ(reasonFor([](Strip&, CutCurves&) {}), "");
    EXPECT_EQ(reasonBehindFront([](Strip&, CutCurves&) {}), "");
}

TEST_F(OutlineRefuses, CurvesThatHaveTheAirOnTheirLeft) {
    EXPECT_EQ(reasonFor([](Strip&, CutCurves& curves) {
                  for (Segment& segment : curves.segments) {
                      std::swap(segment.from, segment.to);
                  }
              }),
              "the blade's border enters the body twice");
}

TEST_F(OutlineRefuses, AirThatLiesInside) {
    EXPECT_EQ(reasonBehindFront([](Strip&, CutCurves& curves) { curves.segments.clear(); }),
              "the air lies inside");
}

// The curves end beside its vertices, not at them.
TEST_F(OutlineRefuses, AFrontInTheAir) {
    EXPECT_EQ(reasonBehindFront([](Strip&, CutCurves& curves) {
                  for (Segment& segment : curves.segments) {
                      for (int* end : {&segment.from, &segment.to}) {
                          if (curves.nodes[*end].kind == NodeKind::vertex) {
                              curves.nodes.push_back(CutNode(curves.nodes[*end]));
                              *end = sizeOf(curves.nodes) - 1;
                          }
                      }
                  }
              }),
              "the front lies outside");
}

TEST_F(OutlineRefuses, ABodyThatIsEnteredTwice) {
    EXPECT_EQ(reasonFor([](Strip& strip, CutCurves& curves) {
                  const auto leaves = std::ranges::find_if(curves.segments, [&](const Segment& s) {
                      return isOnBorder(strip, curves.nodes[s.from]);
                  });
                  std::swap(leaves->from, leaves->to);
              }),
              "the blade's border enters the body twice");
}

TEST_F(OutlineRefuses, ACurveWithAGap) {
    EXPECT_EQ(reasonFor([](Strip&, CutCurves& curves) {
                  const auto isInner = [&](int node) {
                      return curves.nodes[node].kind == NodeKind::edge;
                  };
                  curves.segments.erase(std::ranges::find_if(
                      curves.segments,
                      [&](const Segment& s) { return isInner(s.from) && isInner(s.to); }));
              }),
              "the border of the wall is not closed");
}

TEST_F(OutlineRefuses, TwoCurvesThatEndAtOnePoint) {
    EXPECT_EQ(reasonFor([](Strip& strip, CutCurves& curves) {
                  const auto ends = std::ranges::find_if(curves.segments, [&](const Segment& s) {
                      return isOnBorder(strip, curves.nodes[s.to]);
                  });
                  curves.segments.push_back(Segment(*ends));
              }),
              "two curves end at one point of the blade's border");
}

TEST_F(OutlineRefuses, AStripWithoutABorderAllAround) {
    EXPECT_EQ(reasonFor([](Strip& strip, CutCurves&) {
                  std::ranges::find_if(strip.edges, &StripEdge::onBorder)->onBorder = false;
              }),
              "the border of the strip is open");
    EXPECT_EQ(reasonFor([](Strip& strip, CutCurves&) {
                  const auto inner = std::ranges::find_if_not(strip.edges, &StripEdge::onBorder);
                  inner->onBorder = true;
              }),
              "the strip is pinched");
}

TEST_F(OutlineRefuses, AFreePieceBesideTheFront) {
    EXPECT_EQ(reasonBehindFront([](Strip& strip, CutCurves&) {
                  std::ranges::find_if(strip.edges, [](const StripEdge& e) {
                      return e.frontOf >= 0;
                  })->frontOf = -1;
              }),
              "a free piece beside the old front");
}

void expectClosed(const CutCurves& curves, const Outline& outline) {
    std::vector<int> balance(curves.nodes.size(), 0);
    for (const OutlineEdge& edge : outline.edges) {
        ++balance[edge.from];
        --balance[edge.to];
    }
    EXPECT_EQ(std::ranges::count(balance, 0), sizeOf(balance));
}

void expectCurvesAreCut(const CutCurves& curves, const Outline& outline) {
    std::set<Edge> wanted;
    for (const Segment& segment : curves.segments) {
        wanted.insert({segment.from, segment.to});
    }
    std::set<Edge> found;
    for (const OutlineEdge& edge : outline.edges) {
        if (edge.kind == OutlineKind::cut) {
            found.insert({edge.from, edge.to});
        }
    }
    EXPECT_EQ(found, wanted);
}

double distanceToBorder(const Strip& strip, const Vec2& p) {
    double least = 1e300;
    for (const StripEdge& edge : strip.edges) {
        if (edge.onBorder) {
            const Vec2& a = strip.nodes[edge.a].layout;
            const Vec2 way = strip.nodes[edge.b].layout - a;
            const double share = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
            least = std::min(least, (a + share * way - p).norm());
        }
    }
    return least;
}

/// Free pieces lie on the border of the strip, front edges are edges between the stroke's walls.
void expectKinds(const StepInput& in, const Traced& traced) {
    const auto& [strip, curves, outline] = traced;
    for (const OutlineEdge& edge : outline.edges) {
        const CutNode& from = curves.nodes[edge.from];
        const CutNode& to = curves.nodes[edge.to];
        if (edge.kind == OutlineKind::free) {
            EXPECT_LT(distanceToBorder(strip, 0.5 * (from.layout + to.layout)), kNearBorder);
        } else if (edge.kind == OutlineKind::front) {
            const int h = in.mesh.findHalfEdge(from.a, to.a);
            ASSERT_GE(h, 0);
            EXPECT_EQ(in.mesh.wallLabel(h / 3) / 2, in.stroke);
            EXPECT_EQ(in.mesh.wallLabel(h / 3) ^ 1, in.mesh.wallLabel(in.mesh.twin(h) / 3));
        }
    }
}

void expectFront(const StepInput& in, const Traced& traced) {
    const Outline& outline = traced.outline;
    const std::vector<FrontPoint>& front = outline.front;
    EXPECT_TRUE(front.empty() || !front.back().attached);
    for (int i = 0; i + 1 < sizeOf(front); ++i) {
        EXPECT_GE(front[i].s, front[i + 1].s);
        const bool isFree = std::ranges::any_of(outline.edges, [&](const OutlineEdge& edge) {
            return edge.kind == OutlineKind::free && edge.from == front[i].node &&
                   edge.to == front[i + 1].node;
        });
        EXPECT_TRUE(isFree || !front[i].attached);
    }
    const auto isInside = [&](int node) {
        return !traced.strip.isOld(node) &&
               windingNumber(in.mesh, traced.strip.nodes[node].position) > 0.5;
    };
    EXPECT_EQ(outline.endAInside, isInside(traced.strip.newRung.front()));
    EXPECT_EQ(outline.endBInside, isInside(traced.strip.newRung.back()));
}

/// How often the outline winds around a place.
int windingAround(const CutCurves& curves, const Outline& outline, const Vec2& p) {
    double angle = 0;
    for (const OutlineEdge& edge : outline.edges) {
        const Vec2 a = curves.nodes[edge.from].layout - p;
        const Vec2 b = curves.nodes[edge.to].layout - p;
        angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return static_cast<int>(std::lround(angle / (2 * M_PI)));
}

bool isNearOutline(const CutCurves& curves, const Outline& outline, const Vec2& p) {
    return std::ranges::any_of(outline.edges, [&](const OutlineEdge& edge) {
        const Vec2& a = curves.nodes[edge.from].layout;
        const Vec2 way = curves.nodes[edge.to].layout - a;
        const double share = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
        return (a + share * way - p).norm() < 1e-5;
    });
}

void expectSeparates(const StepInput& in, const Traced& traced, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform{0, 1};
    const Strip& strip = traced.strip;
    for (int i = 0; i < 12; ++i) {
        const Triangle& t = strip.triangles[random() % strip.triangles.size()];
        const double b = uniform(random);
        const double c = uniform(random) * (1 - b);
        const auto mixed = [&](const auto& of) {
            return ((1 - b - c) * of(t[0]) + b * of(t[1]) + c * of(t[2])).eval();
        };
        const Vec2 layout = mixed([&](int k) -> const Vec2& { return strip.nodes[k].layout; });
        const Vec3 place = mixed([&](int k) -> const Vec3& { return strip.nodes[k].position; });
        if (!isNearOutline(traced.curves, traced.outline, layout)) {
            EXPECT_EQ(windingAround(traced.curves, traced.outline, layout),
                      std::lround(windingNumber(in.mesh, place)));
        }
    }
}

TEST(Outline, OfRandomStepsSeparatesTheInsideFromTheAir) {
    const std::uint32_t seed = fuzzSeed(41);
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random{seed};
    int front = 0;
    int inside = 0;
    const int steps = forRandomSteps(seed, 80, [&](const StepInput& in, const PlannedStep&) {
        const Traced traced = trace(in);
        expectClosed(traced.curves, traced.outline);
        expectCurvesAreCut(traced.curves, traced.outline);
        expectKinds(in, traced);
        expectFront(in, traced);
        expectSeparates(in, traced, random);
        front += countOf(traced.outline, OutlineKind::front);
        inside += traced.outline.endBInside;
    });
    EXPECT_GT(steps, 130);
    EXPECT_GT(front, 200);
    EXPECT_GT(inside, 20);
}

}  // namespace
}  // namespace kerf::cut
