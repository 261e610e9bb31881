#include "sim/solve/front_anchors.h"
#include "sim/solve/scatter.h"
#include "sim/solve/solver_pieces.h"

namespace kerf {
namespace {

using shared::kNoVertex;
using shared::kPageSize;

/// Every vertex stands once, on a page of its piece, and no page belongs to two.
void expectHolds(const VertexPages& pages, const std::vector<int>& pieceOf, std::size_t pieces) {
    std::vector<int> seen(pieceOf.size(), 0);
    std::vector<int> owner(pages.places().size() / kPageSize, -1);
    for (std::size_t p = 0; p < pieces; ++p) {
        for (const std::uint32_t page : pages.pagesOf(p)) {
            ASSERT_EQ(std::exchange(owner[page], static_cast<int>(p)), -1);
            for (std::uint32_t i = 0; i < kPageSize; ++i) {
                const std::uint32_t v = pages.places()[page * kPageSize + i];
                if (v != kNoVertex) {
                    EXPECT_EQ(pieceOf[v], static_cast<int>(p));
                    ++seen[v];
                }
            }
        }
    }
    for (std::size_t v = 0; v < pieceOf.size(); ++v) {
        EXPECT_EQ(seen[v], pieceOf[v] >= 0 ? 1 : 0) << v;
    }
}

TEST(VertexPages, KeepVerticesOfAPieceTogetherInOrder) {
    std::vector<int> pieceOf(1000, 0);
    for (int v = 0; v < 1000; v += 3) {
        pieceOf[v] = 1;
    }
    VertexPages pages;
    pages.assign(pieceOf, 2);
    expectHolds(pages, pieceOf, 2);
    EXPECT_EQ(pages.anyVertexOf(0), 1u);
    EXPECT_EQ(pages.anyVertexOf(1), 0u);
    EXPECT_EQ(pages.places()[pages.pagesOf(1)[0] * kPageSize + 1], 3u);
}

TEST(VertexPages, FollowVerticesThatComeAndGo) {
    const unsigned seed = 4;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<int> pieceOf(2000, 0);
    std::vector<std::uint32_t> copy;
    VertexPages pages;
    pages.assign(pieceOf, 1);
    for (int round = 1; round < 20; ++round) {
        std::vector<LabelMove> moves;
        for (std::size_t v = 0; v < pieceOf.size(); ++v) {
            if (random() % 4 == 0) {
                const int to = static_cast<int>(random() % (round + 1)) - (random() % 8 == 0);
                moves.push_back({static_cast<int>(v), pieceOf[v], to});
                pieceOf[v] = to;
            }
        }
        for (int i = 0; i < 30; ++i) {
            moves.push_back({static_cast<int>(pieceOf.size()), -1, 0});
            pieceOf.push_back(0);
        }
        pages.update(moves, pieceOf.size(), round + 1);
        expectHolds(pages, pieceOf, round + 1);
        copy.resize(pages.places().size());
        for (const std::uint32_t place : pages.takeChangedPlaces()) {
            copy[place] = pages.places()[place];
        }
        EXPECT_EQ(copy, pages.places());
    }
}

TEST(VertexPages, APieceThatLostMostOfItsVerticesIsPacked) {
    std::vector<int> pieceOf(20 * kPageSize, 0);
    VertexPages pages;
    pages.assign(pieceOf, 1);
    std::vector<LabelMove> moves;
    for (std::size_t v = 0; v < pieceOf.size(); ++v) {
        if (v % 10 != 0) {
            moves.push_back({static_cast<int>(v), 0, 1});
            pieceOf[v] = 1;
        }
    }
    pages.update(moves, pieceOf.size(), 2);
    expectHolds(pages, pieceOf, 2);
    EXPECT_LE(pages.pagesOf(0).size(), 3u);
}

class ScatterTest : public GlTest {
  protected:
    /// The words of a buffer that some drivers can't bind as storage in one go.
    static std::size_t largeCount() {
        constexpr GLint64 kAffordable = 256 << 20;  // a test takes no more of a large GPU
        GLint64 limit = 0;
        glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
        return static_cast<std::size_t>(std::min(limit, kAffordable)) / 4 + 100'000;
    }

    /// More of them than are written by calls, as far as the last.
    static std::vector<std::uint32_t> spreadIndices(std::size_t count) {
        constexpr std::uint32_t kWrites = 500;
        std::vector<std::uint32_t> indices;
        indices.reserve(kWrites);
        for (std::uint64_t i = 0; i < kWrites; ++i) {
            indices.push_back(static_cast<std::uint32_t>(i * (count - 1) / (kWrites - 1)));
        }
        return indices;
    }
};

TEST_F(ScatterTest, WritesWordsBeyondWhatIsBoundAtOnce) {
    const std::size_t count = largeCount();
    const std::vector<std::uint32_t> indices = spreadIndices(count);
    gpu::Buffer target(gpu::Buffer::Readers::texels);
    Scatter scatter;
    scatter.write<std::uint32_t>(target, count, indices, Scatter::Gaps::keep,
                                 [](std::uint32_t i) { return i + 1; });
    for (const std::uint32_t index : indices) {
        EXPECT_EQ(target.read<std::uint32_t>(index, 1).front(), index + 1);
        EXPECT_EQ(target.read<std::uint32_t>(index == 0 ? 1 : index - 1, 1).front(), 0u);
    }
    EXPECT_EQ(indices.back(), count - 1);
}

constexpr double kStep = 0.005;
constexpr double kCatchUpSpeed = 2;

/// A sphere with a slit half way down, at rest.
struct SlitSphere {
    SlitSphere() {
        cutter.begin({{-1, 0.7, 0.013}, {1, 0.7, 0.013}});
        for (int i = 1; i <= 14; ++i) {
            cutter.advance({{-1, 0.7 - 0.05 * i, 0.013}, {1, 0.7 - 0.05 * i, 0.013}});
        }
        rung = cutter.rung();
        model = buildBodyModel(mesh);
    }
    std::vector<Anchor> anchors() const {
        return findFrontAnchors(rung, {mesh, model.pieceOfVertex, cutter.edgeLengthAtFront(),
                                       cutter.strokeSurface(), kStep, kCatchUpSpeed});
    }

    SurfaceMesh mesh = cubeSphere(8);
    int skinVertices = mesh.vertexCount();
    Cutter cutter{mesh, {}};
    std::vector<RungNode> rung;
    BodyModel model;
};

TEST(FrontAnchors, HoldsTheInnerFrontOnly) {
    const SlitSphere sphere;
    const std::vector<Anchor> anchors = sphere.anchors();
    ASSERT_GT(anchors.size(), 4u);
    for (const Anchor& anchor : anchors) {
        EXPECT_GE(anchor.vertex, sphere.skinVertices);
        EXPECT_LT(sphere.mesh.position(anchor.vertex).norm(), 0.5);
    }
}

// The tip of the blade stands in the material: nothing but the two walls would hold the front's
// end.
TEST(FrontAnchors, HoldsTheEndOfAFrontInsideTheBody) {
    SurfaceMesh mesh = cubeSphere(8);
    Cutter cutter(mesh, {});
    cutter.begin({{-0.7, 1.5, 0.013}, {-0.7, 0.2, 0.013}});
    for (int i = 1; i <= 14; ++i) {
        const double x = -0.7 + 0.05 * i;
        cutter.advance({{x, 1.5, 0.013}, {x, 0.2, 0.013}});
    }
    ASSERT_GE(cutter.rung().back().vertex, 0) << "the tip is inside";
    const BodyModel model = buildBodyModel(mesh);
    const std::vector<Anchor> anchors =
        findFrontAnchors(cutter.rung(), {mesh, model.pieceOfVertex, cutter.edgeLengthAtFront(),
                                         cutter.strokeSurface(), kStep, kCatchUpSpeed});
    const bool held = std::any_of(anchors.begin(), anchors.end(), [&](const Anchor& anchor) {
        return anchor.vertex == cutter.rung().back().vertex;
    });
    EXPECT_TRUE(held);
}

TEST(FrontAnchors, StandsStillAtRest) {
    for (const Anchor& anchor : SlitSphere().anchors()) {
        EXPECT_LT(anchor.velocity.norm(), 1e-6);
    }
}

TEST(FrontAnchors, GoesAlongWithTheBody) {
    SlitSphere sphere;
    const Vec3 velocity(0.3, -2, 0.1);
    for (int v = 0; v < sphere.mesh.vertexCount(); ++v) {
        sphere.mesh.setVelocity(v, velocity);
    }
    for (const Anchor& anchor : sphere.anchors()) {
        EXPECT_LT((anchor.velocity - velocity).norm(), 1e-6);
    }
}

TEST(FrontAnchors, PullsAStrayedVertexBackAtAModestSpeed) {
    SlitSphere sphere;
    const int strayed = sphere.anchors()[2].vertex;
    sphere.mesh.setPosition(strayed, sphere.mesh.position(strayed) + Vec3(0, 0, 0.001));
    EXPECT_NEAR(sphere.anchors()[2].velocity.z(), -0.001 / kStep, 1e-3);
    sphere.mesh.setPosition(strayed, sphere.mesh.position(strayed) + Vec3(0, 0, 0.1));
    EXPECT_NEAR(sphere.anchors()[2].velocity.z(), -kCatchUpSpeed, 1e-6);
}

TEST(FrontAnchors, FollowsAStretch) {
    // The ridge holds the fit towards the identity by 1e-3 of the trace.
    SlitSphere sphere;
    const Vec3 stretch(1.2, 0.9, 1.0);
    for (int v = 0; v < sphere.mesh.vertexCount(); ++v) {
        sphere.mesh.setPosition(v, sphere.mesh.restPosition(v).cwiseProduct(stretch));
    }
    for (const Anchor& anchor : sphere.anchors()) {
        EXPECT_LT(anchor.velocity.norm() * kStep, 0.02 * sphere.model.edgeLength);
    }
}

// What the front is held by reaches as far as the edges there are long, not those of the whole
// body.
TEST(FrontAnchors, GoByTheEdgeLengthAboutTheFront) {
    SurfaceMesh mesh = gradedSphere();
    const auto edgeAtFront = [&](double x) {
        Cutter cutter(mesh, {});
        cutter.begin({{x, 0.8, -0.7}, {x, 0.8, 0.7}});
        for (int i = 1; i <= 30; ++i) {
            cutter.advance({{x, 0.8 - 0.02 * i, -0.7}, {x, 0.8 - 0.02 * i, 0.7}});
        }
        const double edge = cutter.edgeLengthAtFront();
        cutter.finish();
        return edge;
    };
    EXPECT_GT(edgeAtFront(-0.31), 2 * edgeAtFront(0.31));
}

TEST(FrontAnchors, AreNoneOutsideAStroke) {
    SlitSphere sphere;
    sphere.rung.clear();
    EXPECT_TRUE(sphere.anchors().empty());
}

}  // namespace
}  // namespace kerf
