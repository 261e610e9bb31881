// What has collapsed comes back to its shape: pieces turned inside out by parameters at their
// extremes.
#include <spdlog/fmt/fmt.h>

namespace kerf {
namespace {

struct PieceShape {
    double error = 0;   ///< RMS after the best rigid motion, as a share of the diagonal of the body
    double volume = 0;  ///< as a share of that at rest
    double insideOut = 0;
};

/// Of all pieces but debris.
std::vector<PieceShape> shapesOf(const SurfaceMesh& mesh) {
    const BodyModel model = buildBodyModel(mesh);
    std::vector<std::vector<int>> members(model.pieces.size());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (model.pieceOfVertex[v] >= 0) {
            members[model.pieceOfVertex[v]].push_back(v);
        }
    }
    const PieceMap map = findPieces(mesh);
    const std::vector<double> insideOut = sharesInsideOut(model, mesh);
    std::vector<PieceShape> shapes;
    for (std::size_t p = 0; p < members.size(); ++p) {
        if (model.pieces[p].holdsVolume) {
            const Piece& piece = map.pieces[map.ofVertex[members[p].front()]];
            shapes.push_back(
                {rmsShapeError(mesh.restPositions(), mesh.positions(), members[p]) / model.diagonal,
                 piece.volume / piece.restVolume, insideOut[p]});
        }
    }
    return shapes;
}

PieceShape worstOf(const SurfaceMesh& mesh) {
    PieceShape worst{0, 1, 0};
    for (const PieceShape& shape : shapesOf(mesh)) {
        worst.error = std::max(worst.error, shape.error);
        worst.insideOut = std::max(worst.insideOut, shape.insideOut);
        if (std::abs(shape.volume - 1) > std::abs(worst.volume - 1)) {
            worst.volume = shape.volume;
        }
    }
    return worst;
}

std::vector<SurfaceMesh> sixBodies() {
    return {icosphere(1), icosphere(2),    cubeSphere(5),
            torus(16, 8), bentTube(12, 8), box({1, 0.25, 0.6}, 3)};
}

class CollapseTest : public SimulationFixture {
  protected:
    void set(const std::string& name, const ParamValue& value) {
        ASSERT_EQ(simulation->execute(SetParam{name, value}), "");
    }
    void cutAt(double x, int steps = 40) {
        makeStroke(*simulation, {{x, 0.7, 0.8}, {x, 0.7, -0.8}}, {{x, -0.7, 0.8}, {x, -0.7, -0.8}},
                   steps);
    }
    int triangles() { return simulation->mesh().aliveTriangles(); }
    PieceShape worst() { return worstOf(simulation->mesh()); }

    /// `seconds` at the default parameters, less gravity and floor.
    void rest(double seconds) {
        const Params ordinary = weightless();
        for (const ParamInfo& info : paramTable()) {
            set(std::string(info.name), getParam(ordinary, info.name));
        }
        run(static_cast<int>(std::lround(seconds / ordinary.timeStep)));
    }
};

// shared case ispc-zero-and-back: 1,620 triangles became 1,364, and the halves polyhedra.
TEST_F(CollapseTest, HalvesComeBackFromIspcStiffnessZero) {
    Params params = weightless();
    params.floor = -0.65;
    simulation.emplace(builtin("sphere768"), params);
    cutAt(0.1, 50);
    ASSERT_EQ(simulation->measuredPieces().size(), 2);
    const int cut = triangles();
    set("ispc_stiffness", 0.0);
    set("gravity", Vec3(0, -9.81, 0));
    run(200);
    EXPECT_EQ(triangles(), cut);
    EXPECT_GT(worst().insideOut, 0.3);
    set("ispc_stiffness", 0.5);
    run(400);
    EXPECT_EQ(triangles(), cut);
    EXPECT_LT(worst().error, 0.036) << "as they sag under their weight";
    EXPECT_LT(worst().insideOut, 0.01);
    EXPECT_NEAR(worst().volume, 1, 0.01);
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    EXPECT_LT(simulation->bounds().high.y(), 0.6) << "nothing was thrown up";
}

TEST_F(CollapseTest, NothingThatACutLeftIsCleanedAwayOnTheWay) {
    Params params = weightless();
    params.floor = -0.65;
    for (const SurfaceMesh& body : sixBodies()) {
        SCOPED_TRACE(body.aliveTriangles());
        simulation.emplace(SurfaceMesh(body), params);
        cutAt(0.1, 8);
        cutAt(-0.2, 8);
        run(20);
        const int cut = triangles();
        set("ispc_stiffness", 0.0);
        set("gravity", Vec3(0, -9.81, 0));
        run(100);
        set("ispc_stiffness", 0.5);
        run(200);
        EXPECT_EQ(triangles(), cut);
    }
}

/// A small sphere that has no ISPCs and has fallen flat.
class FlatSphereTest : public CollapseTest {
  protected:
    void SetUp() override {
        CollapseTest::SetUp();
        Params params;
        params.iterations = 10;
        params.gravity = Vec3(0, -30, 0);
        params.floor = -0.52;
        params.ispcStiffness = 0;
        simulation.emplace(icosphere(2), params);
        run(200);
    }
};

TEST_F(FlatSphereTest, StaysSoWithoutStiffness) {
    EXPECT_GT(worst().error, 0.1);
    EXPECT_LT(simulation->report().volumeRatio, 0.7);
    EXPECT_TRUE(simulation->takeMessages().empty());
}

TEST_F(FlatSphereTest, IsDrawnBackAndItIsSaid) {
    set("ispc_stiffness", 0.5);
    run(400);
    const std::vector<std::string> messages = simulation->takeMessages();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_NE(messages[0].find("1 piece of 1 collapsed"), std::string::npos) << messages[0];
    rest(1);
    EXPECT_LT(worst().error, 0.02);
}

TEST_F(FlatSphereTest, IsDrawnBackAfterAnUndoOfTheParameter) {
    simulation->setUndoBudget(std::size_t{1} << 30);
    set("ispc_stiffness", 0.5);
    run(30);
    ASSERT_EQ(simulation->execute(Undo{}), "");
    run(150);
    EXPECT_GT(worst().error, 0.1) << "no stiffness";
    ASSERT_EQ(simulation->execute(Redo{}), "");
    run(400);
    rest(1);
    EXPECT_LT(worst().error, 0.02);
}

TEST_F(FlatSphereTest, AMomentKnowsThatItIsDrawnBack) {
    set("ispc_stiffness", 0.5);
    run(40);
    const Checkpoint then = simulation->checkpoint();
    run(60);
    const std::string hash = simulation->stateHash();
    simulation->goTo(then);
    run(60);
    EXPECT_EQ(simulation->stateHash(), hash);
}

// --- Storms ----------------------------------------------------------------------------------

// KERF_COLLAPSE_STORMS: more of them. KERF_COLLAPSE_SEED: others (one storm repeats one).

struct Extreme {
    std::string name;
    std::vector<ParamValue> values;
};

const std::vector<Extreme> kExtremes{
    {"ispc_stiffness", {0.0, 0.0, 0.0, 1e-3, 1.0, 0.5}},
    {"stretch_stiffness", {0.0, 10.0, 1.0}},
    {"bending_stiffness", {0.0, 10.0, 1.0}},
    {"gravity", {Vec3(0, -100, 0), Vec3(0, 100, 0), Vec3(100, 0, 0), Vec3(0, -9.81, 0)}},
    {"iterations", {1.0, 1.0, 5.0, 20.0}},
    {"time_step", {0.02, 0.02, 0.005, 0.001}},
    {"youngs_modulus", {1e3, 1e8, 1e5}},
    {"density", {10.0, 20000.0, 1000.0}},
    {"damping", {0.0, 0.02}},
    {"air_drag", {0.0, 20.0}},
    {"friction", {0.0, 2.0}},
    {"contact", {0.0, 1.0}},
    {"depenetration_speed", {0.01, 10.0}},
    {"solver", {std::string("pbd"), std::string("implicit"), std::string("implicit")}},
    {"floor", {-0.6, -0.3, std::monostate{}}}};

class CollapseStormTest : public CollapseTest {
  protected:
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    double share() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

    void setSomething() {
        const Extreme& extreme = kExtremes[below(static_cast<int>(kExtremes.size()))];
        set(extreme.name, extreme.values[below(static_cast<int>(extreme.values.size()))]);
    }
    void pull() {
        const int vertex = below(simulation->mesh().vertexCount());
        const Vec3 at = simulation->mesh().position(vertex);
        if (simulation->execute(Grab{0, at, 0.2}).empty()) {
            simulation->execute(Drag{0, at + Vec3(share(), share(), share())});
            run(1 + below(10));
            simulation->execute(Release{0});
        }
    }
    void act() {
        switch (below(8)) {
            case 0:
                return cutAt(0.4 * share(), 8);
            case 1:
                return pull();
            default:
                return setSomething();
        }
    }
    void storm(unsigned seed) {
        random_.seed(seed);
        Params params;
        params.floor = -0.55;
        simulation.emplace(sixBodies()[below(6)], params);
        if (below(2) == 0) {
            cutAt(0.05 + 0.1 * share());
        }
        set("ispc_stiffness", 0.0);
        for (int i = 0; i < 12; ++i) {
            act();
            run(1 + below(16));
        }
        before_ = worst();
    }

    std::mt19937 random_;
    PieceShape before_;  ///< when the storm is over
};

TEST_F(CollapseStormTest, WhatStormsCrushComesBack) {
    constexpr unsigned kFirst = 20261123;
    const auto first = static_cast<unsigned>(environmentNumber("KERF_COLLAPSE_SEED", kFirst));
    const auto storms = static_cast<unsigned>(runs("KERF_COLLAPSE_STORMS", 2, 10));
    unsigned bent = 0;
    for (unsigned i = 0; i < storms; ++i) {
        SCOPED_TRACE("KERF_COLLAPSE_STORMS=1 KERF_COLLAPSE_SEED=" + std::to_string(first + i));
        storm(first + i);
        const int left = triangles();
        rest(4);
        const PieceShape after = worst();
        std::cout << fmt::format(
            "seed {}: {} pieces, {} triangles; inside out {:.3f}, error {:.4f}, volume {:.3f}; "
            "four seconds later {:.3f}, {:.4f}, {:.3f}\n",
            first + i, simulation->measuredPieces().size(), left, before_.insideOut, before_.error,
            before_.volume, after.insideOut, after.error, after.volume);
        EXPECT_GT(triangles(), 0.97 * left) << "but for slivers, which are mended";
        EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
        EXPECT_LT(after.insideOut, 0.01);
        EXPECT_NEAR(after.volume, 1, 0.01);
        EXPECT_LT(after.error, 0.06);
        bent += after.error < 0.02 ? 0 : 1;
    }
    EXPECT_LE(10 * bent, storms) << "pieces that lie in each other hold each other";
}

}  // namespace
}  // namespace kerf
