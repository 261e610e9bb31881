// A scene of several models, each of its own material.

namespace kerf {
namespace {

constexpr double kApart = 2;  // between the middles of both [m]
constexpr std::size_t kUndoBudget = 1u << 30;

/// One behind the other.
SurfaceMesh both(const SurfaceMesh& first, const SurfaceMesh& second) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    for (const SurfaceMesh* mesh : {&first, &second}) {
        const int offset = static_cast<int>(positions.size());
        positions.reserve(positions.size() + mesh->vertexCount());
        triangles.reserve(triangles.size() + mesh->triangleSlots());
        for (int v = 0; v < mesh->vertexCount(); ++v) {
            positions.push_back(mesh->restPosition(v));
        }
        for (int t = 0; t < mesh->triangleSlots(); ++t) {
            const auto& [a, b, c] = mesh->triangle(t);
            triangles.push_back({a + offset, b + offset, c + offset});
        }
    }
    return SurfaceMesh::fromTriangles(positions, triangles);
}

std::vector<Vec3> positionsFrom(const SurfaceMesh& mesh, int first) {
    std::vector<Vec3> positions(mesh.vertexCount() - first);
    for (int v = first; v < mesh.vertexCount(); ++v) {
        positions[v - first] = mesh.position(v);
    }
    return positions;
}

// Contact makes ten times as much of a difference every 10 ms.
constexpr int kLanding = 68;      // steps until the bar has been on the floor for 20 ms
constexpr int kStepsOfFall = 80;  // and for 50 ms
constexpr double kAlike = 1e-4;   // how far bars may be apart that should be alike [m]

class SeveralModelsTest : public SimulationFixture {
  protected:
    /// A ball and beside it a smaller, longish box.
    void SetUp() override {
        SimulationFixture::SetUp();
        params.floor = -0.5;
        // Not by the state, on which the faster model decides for both.
        params.iterations = 8;
        params.timeStep = 0.0025;
        begin(params);
    }
    Simulation made(const Params& with) const {
        const std::vector<PlacedModel> models{{}, {{}, ball.vertexCount()}};
        return {BodyUpload(PreparedBody(both(ball, bar), {}, models)), with};
    }
    void begin(const Params& with) {
        simulation.emplace(made(with));
        simulation->setUndoBudget(kUndoBudget);
    }
    /// Where the vertices of the second are after so many steps.
    std::vector<Vec3> barAfter(int steps) {
        run(steps);
        return positionsFrom(simulation->mesh(), ball.vertexCount());
    }
    /// In another scene; rays turn by the numbers of vertices, so that there is a ball as well.
    std::vector<Vec3> barAfter(int steps, const Params& with) const {
        Simulation other = made(with);
        for (int i = 0; i < steps; ++i) {
            other.step();
        }
        return positionsFrom(other.mesh(), ball.vertexCount());
    }
    static double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
        double most = 0;
        for (std::size_t v = 0; v < a.size(); ++v) {
            most = std::max(most, (a[v] - b[v]).norm());
        }
        return most;
    }
    std::string cutThroughBoth() {
        makeStroke(*simulation, {{-1, 0.8, 0.011}, {kApart + 1, 0.8, 0.012}},
                   {{-1, -0.8, 0.011}, {kApart + 1, -0.8, 0.012}}, 20);
        return simulation->stateHash();
    }

    Params params;
    SurfaceMesh ball = cubeSphere(6, 0.5);
    SurfaceMesh bar = movedBy(box(Vec3(0.6, 0.4, 0.3), 4), Vec3(kApart, -0.2, 0));
};

TEST_F(SeveralModelsTest, EachFallsAsIfItWereAlone) {
    EXPECT_EQ(simulation->modelCount(), 2);
    Params otherBall = params;
    otherBall.youngsModulus = 5e3;
    otherBall.density = 1500;
    ASSERT_EQ(setParam(otherBall, "youngs_modulus@1", params.youngsModulus), "");
    ASSERT_EQ(setParam(otherBall, "density@1", params.density), "");
    EXPECT_LT(apart(barAfter(kLanding, params), barAfter(kLanding, otherBall)), kAlike);
}

TEST_F(SeveralModelsTest, OneOfItsOwnMaterialIsAsASceneOfThatMaterial) {
    Params soft = params;
    soft.youngsModulus = 5e3;
    soft.density = 1500;
    Params own = params;
    ASSERT_EQ(setParam(own, "youngs_modulus@1", soft.youngsModulus), "");
    ASSERT_EQ(setParam(own, "density@1", soft.density), "");
    const std::vector<Vec3> alone = barAfter(kStepsOfFall, soft);
    EXPECT_LT(apart(barAfter(kStepsOfFall, own), alone), kAlike);
    EXPECT_GT(apart(barAfter(kStepsOfFall, params), alone), 5e-3);  // it makes a difference
}

TEST_F(SeveralModelsTest, AMaterialMayChangeOnTheWayAndUndoTakesItBack) {
    EXPECT_EQ(simulation->execute(SetParam{"youngs_modulus@1", 5e3}), "");
    EXPECT_EQ(simulation->history().lastDone().name, "Young's modulus of model 1: 5000 Pa");
    Params soft = params;
    soft.youngsModulus = 5e3;
    EXPECT_LT(apart(barAfter(kStepsOfFall), barAfter(kStepsOfFall, soft)), kAlike);
    EXPECT_EQ(simulation->execute(Undo{}), "");
    EXPECT_TRUE(simulation->params() == params);
    EXPECT_EQ(simulation->execute(SetParam{"density@2", 100.0}),
              "There is no model 2; the scene has 2 models, numbered from 0.");
}

TEST_F(SeveralModelsTest, PiecesStayOfTheirModel) {
    cutThroughBoth();
    EXPECT_EQ(simulation->report().pieces, 4);
    const BodyModel& model = simulation->bodyModel();
    for (std::size_t v = 0; v < model.restPositions.size(); ++v) {
        if (model.pieceOfVertex[v] >= 0) {
            const int wanted = model.restPositions[v].x() > 0.5 * kApart ? 1 : 0;
            EXPECT_EQ(model.pieces[model.pieceOfVertex[v]].member, wanted);
        }
    }
    EXPECT_NEAR(model.members[0].thickness, buildBodyModel(ball).members[0].thickness, 1e-12);
    EXPECT_NEAR(model.members[1].thickness, buildBodyModel(bar).members[0].thickness, 1e-12);
}

TEST_F(SeveralModelsTest, ACutWithAMaterialOnTheWayIsThatOfOneFromTheStart) {
    Params own = params;
    ASSERT_EQ(setParam(own, "youngs_modulus@1", 2e4), "");
    begin(own);
    const std::string fromTheStart = cutThroughBoth();
    begin(params);
    ASSERT_EQ(simulation->execute(SetParam{"youngs_modulus@1", 2e4}), "");
    EXPECT_EQ(cutThroughBoth(), fromTheStart);
}

TEST_F(SeveralModelsTest, OneIsPlacedAndTheOtherStays) {
    Placement higher;
    higher.translate = Vec3(0, 1, 0);
    EXPECT_EQ(simulation->execute(Place{higher, false, 1}), "");
    EXPECT_EQ(simulation->placement(0), Placement{});
    EXPECT_EQ(simulation->placement(1), higher);
    EXPECT_TRUE(simulation->params() == params);  // it is as large as it was
    EXPECT_LT((simulation->mesh().position(0) - ball.restPosition(0)).norm(), 1e-6);
    const Vec3 wanted = bar.restPosition(0) + higher.translate;
    EXPECT_LT((simulation->mesh().position(ball.vertexCount()) - wanted).norm(), 1e-6);
    EXPECT_EQ(simulation->execute(Undo{}), "");
    EXPECT_EQ(simulation->placement(1), Placement{});
    EXPECT_THAT(simulation->execute(Place{higher, false, 2}), HasSubstr("no model 2"));
}

}  // namespace
}  // namespace kerf
