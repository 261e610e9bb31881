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
    Vec3 middle() { return middleOf(simulation->mesh()); }
    double lowest() { return meshBounds(simulation->mesh()).low.y(); }
    double fastest() { return topSpeed(simulation->mesh()); }
    /// A stroke through the middle, from above.
    void cut(double depth) {
        leadBlade(*simulation, {{0.03, 0.7, -1}, {0.05, 0.7, 1}},
                  {{0.03, 0.7 - depth, -1}, {0.05, 0.7 - depth, 1}}, 12);
        simulation->execute(LiftBlade{});
    }
};

TEST_F(ImplicitScenesTest, ABallComesToRestOnTheFloorOrOnABox) {
    for (const bool onBox : {false, true}) {
        Params dragged = params();
        dragged.floor = -0.55;
        dragged.airDrag = 3;
        if (onBox) {
            dragged.floor.reset();
        }
        begin(dragged);
        if (onBox) {
            ASSERT_EQ(simulation->execute(AddBox{{{0, -0.8, 0}, {2, 0.5, 2}}}), "");
        }
        run(360);
        EXPECT_NEAR(lowest(), -0.55, onBox ? 0.02 : 0.01);
        EXPECT_LT(fastest(), 0.05);
        EXPECT_NEAR(simulation->report().volumeRatio, 1, 1e-3);
    }
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
