// Scenes whose steps are implicit: see docs/notes/implicit-steps.md.

namespace kerf {
namespace {

class ImplicitScenesTest : public SimulationFixture {
  protected:
    static Params params() {
        Params params;
        params.solver = SolverMode::implicit;
        params.iterations = kAutoIterations;
        params.timeStep = 1.0 / 120;
        params.floor.reset();
        return params;
    }
    /// A ball of 1 m.
    void begin(const Params& params) { simulation.emplace(icosphere(2), params); }
    Vec3 middle() {
        const std::vector<Vec3> places = simulation->mesh().positions();
        return std::accumulate(places.begin(), places.end(), Vec3(Vec3::Zero())) /
               static_cast<double>(places.size());
    }
    double lowest() {
        Bounds bounds;
        for (const Vec3& p : simulation->mesh().positions()) {
            bounds.add(p);
        }
        return bounds.low.y();
    }
    double fastest() {
        double most = 0;
        for (int v = 0; v < simulation->mesh().vertexCount(); ++v) {
            most = std::max(most, simulation->mesh().velocity(v).norm());
        }
        return most;
    }
    /// A stroke through the middle, from above.
    void cut(double depth) {
        for (int i = 0; i <= 12; ++i) {
            const double y = 0.7 - depth * i / 12;
            simulation->execute(MoveBlade{{{0.03, y, -1}, {0.05, y, 1}}});
            simulation->step();
        }
        simulation->execute(LiftBlade{});
    }
};

TEST_F(ImplicitScenesTest, ABallComesToRestOnTheFloor) {
    Params dragged = params();
    dragged.floor = -0.55;
    dragged.airDrag = 3;
    begin(dragged);
    run(360);
    EXPECT_NEAR(lowest(), -0.55, 0.01);
    EXPECT_LT(fastest(), 0.05);
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 1e-3);
}

TEST_F(ImplicitScenesTest, ABallComesToRestOnABox) {
    Params dragged = params();
    dragged.airDrag = 3;
    begin(dragged);
    ASSERT_EQ(simulation->execute(AddBox{{{0, -0.8, 0}, {2, 0.5, 2}}}), "");
    run(360);
    EXPECT_NEAR(lowest(), -0.55, 0.02);
    EXPECT_LT(fastest(), 0.05);
}

TEST_F(ImplicitScenesTest, HalvesThatFallStaySoundAndRepeatToTheBit) {
    std::vector<std::string> hashes;
    for (int turn = 0; turn < 2; ++turn) {
        Params falling = params();
        falling.floor = -0.8;
        begin(falling);
        cut(1.5);
        run(60);
        EXPECT_EQ(simulation->report().pieces, 2);
        EXPECT_TRUE(simulation->report().closed);
        EXPECT_NEAR(simulation->report().volumeRatio, 1, 0.01);
        EXPECT_EQ(simulation->report().lostPieces, 0);
        hashes.push_back(simulation->stateHash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

// Walls across all axes, with whole aggregates on them.
TEST_F(ImplicitScenesTest, ASlitBodyIsNotStrainedByAFall) {
    Params falling = params();
    falling.youngsModulus = 3e5;
    falling.gravity.setZero();
    simulation.emplace(cubeSphere(16, 0.5), falling);
    cut(1.0);
    simulation->execute(SetParam{"gravity", Vec3(0, -9.81, 0)});
    run(40);
    EXPECT_GT(simulation->report().kineticEnergy, 1000);
    EXPECT_LT(*simulation->report().strainEnergy, 1e-4 * simulation->report().kineticEnergy);
}

TEST_F(ImplicitScenesTest, AMomentGoesOnToTheBit) {
    Params falling = params();
    falling.floor = -0.6;
    begin(falling);
    cut(1.0);
    run(10);
    const Checkpoint then = simulation->checkpoint();
    run(20);
    const std::string after = simulation->stateHash();
    simulation->goTo(then);
    run(20);
    EXPECT_EQ(simulation->stateHash(), after);
}

TEST_F(ImplicitScenesTest, TheReportTellsOfHowManyStepsATimeStepIsMade) {
    Params floating = params();
    floating.timeStep = 0.02;  // longer than the longest step of any body
    begin(floating);
    EXPECT_EQ(simulation->step().implicitSteps, 2);
    const auto moment = bytesOf(simulation->checkpoint());
    ASSERT_EQ(simulation->execute(SetParam{"solver", std::string("pbd")}), "");
    EXPECT_EQ(simulation->step().implicitSteps, 1);
    ASSERT_TRUE(simulation->goTo(*moment));
    EXPECT_EQ(simulation->report().implicitSteps, 2);
}

TEST_F(ImplicitScenesTest, TheReportTellsWhatIterationsLeft) {
    std::vector<double> left;
    for (const int iterations : {2, 4, 20}) {
        Params falling = params();
        falling.iterations = iterations;
        falling.floor = -0.52;
        begin(falling);
        run(12);
        ASSERT_TRUE(simulation->report().residual);
        left.push_back(*simulation->report().residual);
    }
    EXPECT_LT(left[0], 1);
    EXPECT_LT(left[1], 0.5 * left[0]);
    EXPECT_LT(left[2], 0.1 * left[1]);
    ASSERT_EQ(simulation->execute(SetParam{"solver", std::string("pbd")}), "");
    EXPECT_FALSE(simulation->step().residual);
}

TEST_F(ImplicitScenesTest, AHandPullsTheBodyAlong) {
    Params floating = params();
    floating.gravity.setZero();
    floating.airDrag = 5;
    begin(floating);
    ASSERT_EQ(simulation->execute(Grab{0, Vec3(0.5, 0, 0), 0.2}), "");
    for (int step = 1; step <= 60; ++step) {
        ASSERT_EQ(simulation->execute(Drag{0, Vec3(0.5 + 0.01 * step, 0, 0)}), "");
        simulation->step();
    }
    run(180);
    EXPECT_NEAR(middle().x(), 0.6, 0.05);
    for (const Hands::Held& each : simulation->hands().at(0).held) {
        const Vec3 wanted = Vec3(1.1, 0, 0) + each.offset;
        EXPECT_LT((simulation->mesh().position(each.vertex) - wanted).norm(), 0.02);
    }
}

TEST_F(ImplicitScenesTest, AForceAcceleratesTheBody) {
    Params floating = params();
    floating.gravity.setZero();
    floating.airDrag = 0;
    begin(floating);
    const double mass = floating.density * simulation->report().volume;
    ASSERT_EQ(simulation->execute(ApplyForce{Ball{{0, 0, 0}, 2}, {mass, 0, 0}}), "");
    run(60);
    EXPECT_NEAR(middle().x(), 0.5 * 0.5 * 0.5, 0.01);
}

TEST_F(ImplicitScenesTest, PinsCarryTheBodyAlong) {
    Params floating = params();
    floating.gravity.setZero();
    begin(floating);
    ASSERT_EQ(simulation->execute(
                  Pin{Ball{{0, 0.5, 0}, 0.25}, true, false, Vec3(0.4, 0, 0), std::nullopt}),
              "");
    run(240);
    const double way = 0.4 * 240 * floating.timeStep;
    EXPECT_GT(middle().x(), 0.6 * way) << "drawn by its top through the air";
    EXPECT_LT(middle().x(), way);
}

}  // namespace
}  // namespace kerf
