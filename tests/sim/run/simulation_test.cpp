#include "sim/run/simulation.h"

#include "sim/solve/body_view.h"

namespace kerf {
namespace {

constexpr double kRadius = 0.5;

class SimulationTest : public GlTest {};

Params floating() {
    Params params;
    params.gravity = Vec3::Zero();
    params.floor.reset();
    return params;
}

/// The floor lies `drop` below the lowest point of a body of radius 0.5 around the origin.
Params dropped(double drop) {
    Params params;
    params.floor = -kRadius - drop;
    return params;
}

/// A blade along x at height y, a little off the middle so that it meets no vertex exactly.
Blade bladeAt(double y) {
    return {{-1, y, 0.013}, {1, y, 0.013}};
}

/// Takes the blade from `top` down to `bottom` in `steps` steps and lifts it. `each` runs after
/// every step.
void cutDown(
    Simulation& simulation, double top, double bottom, int steps,
    const std::function<void()>& each = [] {}) {
    for (int i = 0; i <= steps; ++i) {
        const double y = top + (bottom - top) * i / steps;
        ASSERT_EQ(simulation.execute(MoveBlade{bladeAt(y)}), "");
        simulation.step();
        each();
    }
    ASSERT_EQ(simulation.execute(LiftBlade{}), "");
    simulation.step();
    each();
}

double shapeError(Simulation& simulation) {
    const SurfaceMesh& mesh = simulation.mesh();
    std::vector<int> all(mesh.vertexCount());
    std::iota(all.begin(), all.end(), 0);
    return rmsShapeError(mesh.restPositions(), mesh.positions(), all);
}

TEST_F(SimulationTest, ReportsTheBodyBeforeTheFirstStep) {
    Simulation simulation(cubeSphere(8), floating());
    const StepReport& report = simulation.report();
    EXPECT_EQ(simulation.stepCount(), 0);
    EXPECT_EQ(report.vertices, 386);
    EXPECT_EQ(report.triangles, 768);
    EXPECT_EQ(report.ispcs, 3 * 386);
    EXPECT_EQ(report.pieces, 1);
    EXPECT_NEAR(report.volumeRatio, 1, 1e-6);
    EXPECT_TRUE(report.closed);
}

TEST_F(SimulationTest, StaysAtRestWithoutForces) {
    Simulation simulation(cubeSphere(8), floating());
    step(simulation, 50);
    EXPECT_LT(topSpeed(simulation.mesh()), 5e-4);
    EXPECT_LT(shapeError(simulation), 1e-6);
}

TEST_F(SimulationTest, RefusesBadParametersWithASentence) {
    Simulation simulation(icosphere(1), Params{});
    EXPECT_NE(simulation.execute(SetParam{"gravitas", 1.0}), "");
    EXPECT_NE(simulation.execute(SetParam{"time_step", 1e3}), "");
    EXPECT_NE(simulation.execute(SetParam{"time_step", 0.0}), "");
    EXPECT_NE(simulation.execute(SetParam{"gravity", 1.0}), "");
    EXPECT_NE(simulation.execute(SetParam{"density", std::nan("")}), "");
    EXPECT_TRUE(simulation.params() == Params{});
    EXPECT_EQ(simulation.execute(SetParam{"density", 500.0}), "");
    EXPECT_EQ(simulation.params().density, 500);
}

TEST_F(SimulationTest, RefusesABladeThatIsNone) {
    Simulation simulation(icosphere(1), Params{});
    Blade blade = bladeAt(1);
    blade.b.z() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(simulation.execute(MoveBlade{blade}), "");
    blade.b = blade.a;
    EXPECT_NE(simulation.execute(MoveBlade{blade}), "");
    simulation.step();
    EXPECT_FALSE(simulation.blade().has_value());
}

TEST_F(SimulationTest, AppliesParametersFromTheNextStepOn) {
    Simulation simulation(icosphere(1), floating());
    step(simulation, 2);
    EXPECT_EQ(simulation.execute(SetParam{"gravity", Vec3(0, 3, 0)}), "");
    EXPECT_EQ(simulation.execute(SetParam{"air_drag", 0.0}), "");
    step(simulation, 10);
    const Vec3& velocity = simulation.mesh().velocity(0);
    EXPECT_NEAR(velocity.y(), 3 * 10 * 0.005, 1e-3);
}

TEST_F(SimulationTest, DroppedSphereIsSoftAndKeepsItsVolume) {
    const Params params = dropped(0.5);
    for (const SurfaceMesh& mesh : {icosphere(0), icosphere(1), cubeSphere(8)}) {
        SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices");
        Simulation simulation(mesh, params);
        const double diagonal = meshBounds(mesh).diagonal();
        constexpr int kSteps = 200;
        double meanVolume = 0;
        double peakError = 0;
        for (int step = 0; step < kSteps; ++step) {
            meanVolume += simulation.step().volumeRatio / kSteps;
            peakError = std::max(peakError, shapeError(simulation) / diagonal);
            ASSERT_EQ(checkFinite(simulation.mesh()), "");
        }
        EXPECT_GT(meanVolume, 0.995);
        EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
        EXPECT_GT(peakError, 0.03);
        EXPECT_GT(meshBounds(simulation.mesh()).low.y(), *params.floor - 1e-3);
        EXPECT_TRUE(simulation.takeMessages().empty());
    }
}

/// The top speed in `steps` steps.
double fastestIn(Simulation& simulation, int steps) {
    double fastest = 0;
    for (int i = 0; i < steps; ++i) {
        simulation.step();
        fastest = std::max(fastest, topSpeed(simulation.mesh()));
    }
    return fastest;
}

TEST_F(SimulationTest, ACollapsedBodyIsFilledAgainWithoutBeingShotOff) {
    Params params = dropped(0.5);
    params.ispcStiffness = 0;
    Simulation simulation(icosphere(1), params);
    step(simulation, 300);
    ASSERT_LT(simulation.report().volumeRatio, 0.5);
    ASSERT_EQ(simulation.execute(SetParam{"ispc_stiffness", 0.5}), "");
    EXPECT_LT(fastestIn(simulation, 400), 15);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
    EXPECT_LT(simulation.bounds().high.y(), 0.5);
    // That a part is inside out.
    EXPECT_LE(simulation.takeMessages().size(), 1U);
}

TEST_F(SimulationTest, WhatPlainPbdTurnedInsideOutComesBack) {
    Params params = floating();
    params.solver = SolverMode::pbd;
    Simulation simulation(cubeSphere(8), params);
    ASSERT_EQ(simulation.execute(Pin{Ball{{0, -0.5, 0}, 0.2}}), "");
    ASSERT_EQ(simulation.execute(Grab{0, {0, 0.5, 0}, 0.3}), "");
    for (int i = 1; i <= 40; ++i) {
        ASSERT_EQ(simulation.execute(Drag{0, {0, 0.5 - 0.05 * i, 0}}), "");
        simulation.step();
    }
    step(simulation, 15);
    ASSERT_EQ(simulation.execute(Release{0}), "");
    step(simulation, 40);
    ASSERT_LT(simulation.report().volumeRatio, -0.5);
    ASSERT_EQ(simulation.execute(SetParam{"solver", std::string("implicit")}), "");
    EXPECT_LT(fastestIn(simulation, 300), 50);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 0.01);
    EXPECT_THAT(simulation.takeMessages(),
                ElementsAre("step 101: 1 piece of 1 collapsed, partly inside out, and is "
                            "drawn back to its shape at rest."));
}

TEST_F(SimulationTest, ARaisedFloorLiftsTheBodyGently) {
    Simulation simulation(icosphere(2), dropped(0));
    step(simulation, 20);
    EXPECT_EQ(simulation.execute(SetParam{"floor", *simulation.params().floor + 0.2}), "");
    EXPECT_LT(fastestIn(simulation, 80), 4);
    EXPECT_GT(meshBounds(simulation.mesh()).low.y(), *simulation.params().floor - 1e-3);
}

TEST_F(SimulationTest, ABladeThatMissesChangesNothing) {
    Simulation with(icosphere(2), dropped(0.1));
    Simulation without(icosphere(2), dropped(0.1));
    for (int step = 0; step < 20; ++step) {
        const double y = 1 - 0.1 * step;
        with.execute(MoveBlade{Blade{{-1, y, 2}, {1, y, 2}}});
        with.step();
        without.step();
    }
    EXPECT_EQ(with.stateHash(), without.stateHash());
    EXPECT_EQ(with.lastCut().outcome, CutOutcome::air);
}

class CutAtRestTest : public SimulationTest, public testing::WithParamInterface<SolverMode> {};

TEST_P(CutAtRestTest, CutsInTwoWithoutMovingAnything) {
    Params params = floating();
    params.solver = GetParam();
    Simulation simulation(cubeSphere(8), params);
    const double diagonal = meshBounds(simulation.mesh()).diagonal();
    double fastest = 0;
    cutDown(simulation, 0.7, -0.7, 30, [&] {
        EXPECT_TRUE(simulation.report().closed);
        EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-4);
        fastest = std::max(fastest, topSpeed(simulation.mesh()));
    });
    EXPECT_EQ(simulation.report().pieces, 2);
    EXPECT_LT(std::max(fastest, fastestIn(simulation, 20)), 1e-3 * diagonal);
    EXPECT_GT(simulation.report().vertices, 386);
    EXPECT_EQ(checkClosedManifold(simulation.mesh()), "");
    EXPECT_THAT(simulation.takeMessages(), IsEmpty());
    ASSERT_EQ(simulation.pieces().pieces.size(), 2u);
    const auto& pieces = simulation.pieces().pieces;
    EXPECT_NEAR(pieces[0].volume + pieces[1].volume, meshRestVolume(cubeSphere(8)), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Solvers, CutAtRestTest,
                         testing::Values(SolverMode::implicit, SolverMode::pbd),
                         [](const auto& each) {
                             return each.param == SolverMode::pbd ? "pbd" : "implicit";
                         });

TEST_F(SimulationTest, HalvesFallApartAndKeepTheirVolume) {
    Params params = dropped(0.3);
    params.gravity = Vec3::Zero();
    Simulation simulation(cubeSphere(8), params);
    cutDown(simulation, 0.7, -0.7, 30);
    ASSERT_EQ(simulation.report().pieces, 2);
    simulation.execute(SetParam{"gravity", Vec3(0, -9.81, 0)});
    double meanVolume = 0;
    constexpr int kSteps = 250;
    for (int i = 0; i < kSteps; ++i) {
        meanVolume += simulation.step().volumeRatio / kSteps;
        ASSERT_TRUE(simulation.report().closed);
    }
    EXPECT_GT(meanVolume, 0.995);
    EXPECT_GT(simulation.report().volumeRatio, 0.999);
    EXPECT_EQ(checkFinite(simulation.mesh()), "");
}

TEST_F(SimulationTest, CutsASaggingBodyInTwo) {
    // Without the anchored front this ends at 12 m/s in one piece.
    Simulation simulation(cubeSphere(8), dropped(0));
    step(simulation, 60);
    double fastest = 0;
    cutDown(simulation, 0.75, -0.75, 120, [&] {
        EXPECT_TRUE(simulation.report().closed);
        fastest = std::max(fastest, topSpeed(simulation.mesh()));
    });
    EXPECT_EQ(simulation.report().pieces, 2);
    EXPECT_LT(fastest, 8);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 2e-3);
}

TEST_F(SimulationTest, ABladeThatLeavesEndsItsStrokeAsOneThatIsLifted) {
    const auto cut = [](const Command& end) {
        Simulation simulation(cubeSphere(4), floating());
        for (int i = 0; i <= 28; ++i) {
            EXPECT_EQ(simulation.execute(MoveBlade{bladeAt(0.8 - 0.05 * i)}), "");
            simulation.step();
        }
        EXPECT_FALSE(simulation.rung().empty()) << "the way here lay beside the body";
        EXPECT_EQ(simulation.execute(MoveBlade{bladeAt(-3)}), "");
        simulation.step();
        EXPECT_EQ(simulation.execute(end), "");
        simulation.step();
        EXPECT_TRUE(simulation.rung().empty());
        EXPECT_EQ(simulation.report().pieces, 2);
        return simulation.stateHash();
    };
    EXPECT_EQ(cut(MoveBlade{bladeAt(-4)}), cut(LiftBlade{}));
}

TEST_F(SimulationTest, ABladeThatStandsStillCutsNothing) {
    Simulation simulation(cubeSphere(8), floating());
    for (int i = 0; i <= 10; ++i) {
        simulation.execute(MoveBlade{bladeAt(0.7 - 0.05 * i)});
        simulation.step();
    }
    const int triangles = simulation.report().triangles;
    ASSERT_GT(triangles, 768);
    for (int i = 0; i < 5; ++i) {
        simulation.execute(MoveBlade{bladeAt(0.2)});
        EXPECT_EQ(simulation.step().touchedTriangles, 0);
    }
    EXPECT_EQ(simulation.report().triangles, triangles);
    EXPECT_TRUE(simulation.blade().has_value());
}

TEST_F(SimulationTest, ResetIsAFreshSimulation) {
    Simulation simulation(icosphere(2), dropped(0.1));
    const std::string fresh = simulation.stateHash();
    const auto play = [&] {
        cutDown(simulation, 0.7, -0.3, 20);
        simulation.execute(SetParam{"gravity", Vec3(0, 4, 0)});
        step(simulation, 5);
        return simulation.stateHash();
    };
    const std::string first = play();
    EXPECT_NE(first, fresh);
    simulation.reset();
    EXPECT_EQ(simulation.stateHash(), fresh);
    EXPECT_EQ(simulation.stepCount(), 0);
    EXPECT_EQ(simulation.report().pieces, 1);
    EXPECT_TRUE(simulation.params() == dropped(0.1));
    EXPECT_FALSE(simulation.blade().has_value());
    EXPECT_EQ(play(), first);
}

// A body that pierces itself everywhere.
TEST_F(SimulationTest, KeepsWhatItSaidOfARefusedStep) {
    SurfaceMesh mesh = icosphere(2);
    std::mt19937_64 engine(11);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const auto random = [&] { return 0.3 * (static_cast<double>(engine() >> 11) * 0x1p-53); };
        mesh.setPosition(v, mesh.position(v) + Vec3(random(), random(), random()));
        mesh.setRestPosition(v, mesh.position(v));
    }
    Simulation simulation(mesh, floating());
    EXPECT_EQ(simulation.refusalOfStroke(), "");
    cutDown(simulation, 1.0, -0.4, 20);
    const std::string refusal = simulation.refusalOfStroke();
    EXPECT_THAT(refusal, HasSubstr("the cut was refused"));
    EXPECT_THAT(simulation.takeMessages(), Contains(refusal));
}

TEST_F(SimulationTest, RecoversFromNumbersThatAreNotFinite) {
    Simulation simulation(icosphere(2), dropped(0.1));
    step(simulation, 3);
    const std::vector<Vec3> good = simulation.mesh().positions();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    glNamedBufferSubData(simulation.bodyView().positions->id(), 0, sizeof nan, &nan);
    simulation.step();
    EXPECT_THAT(simulation.takeMessages(), ElementsAre(StartsWith("step 3: ")));
    EXPECT_EQ(simulation.mesh().positions(), good);
    EXPECT_EQ(topSpeed(simulation.mesh()), 0);
    step(simulation, 3);
    EXPECT_THAT(simulation.takeMessages(), IsEmpty());
    EXPECT_EQ(checkFinite(simulation.mesh()), "");
}

/// Halves that fall on each other, on a box and on the floor.
Simulation fallingHalves(const Params& params) {
    Simulation simulation(cubeSphere(6), params,
                          {{{0.1, -0.6, 0.3}, {0.3, 0.2, 0.3}, {0, 20, 10}}});
    cutDown(simulation, 0.7, -0.7, 25);
    step(simulation, 20);
    return simulation;
}

std::string hashOfACut() {
    Params params = dropped(0.05);
    params.contact = 1;
    Simulation simulation = fallingHalves(params);
    EXPECT_GT(simulation.report().contacts, 0);
    return simulation.stateHash();
}

/// In range, and not too far from what it is: what a slider gives while it is dragged.
ParamValue draggedValue(const Params& params, const ParamInfo& info) {
    const ParamValue now = getParam(params, info.name);
    if (const Vec3* vector = std::get_if<Vec3>(&now)) {
        return Vec3(*vector + Vec3(0.5, 0.5, 0));
    }
    if (std::holds_alternative<std::string>(now)) {
        const bool isAuto = info.type == ParamType::integer;
        return isAuto ? ParamValue(5.0) : ParamValue(std::string(info.choices[1]));
    }
    const double value = std::get<double>(now);
    if (info.type == ParamType::integer && info.high == 1) {
        return 1 - value;
    }
    return info.type == ParamType::integer ? value + 5 : value + 0.2 * std::abs(value);
}

// Of halves that lie on each other, on a box and on the floor, so that everything has a say.
TEST_F(SimulationTest, EveryParameterCanBeChangedWhileTheBodyMoves) {
    Params params = dropped(0.05);
    params.contactThickness = 0.1;
    params.skinThickness = 0.005;
    Simulation simulation = fallingHalves(params);
    step(simulation, 30);
    const Checkpoint then = simulation.checkpoint();
    step(simulation, 5);
    const std::string unchanged = simulation.stateHash();
    // Without a blade or a pull these wait for the next stroke, a tear, or another solver.
    const std::set<std::string_view> waiting{"blade_push",      "blade_width",
                                             "blade_thickness", "blade_feels",
                                             "toughness",       "blade_bluntness",
                                             "tearing",         "tensile_strength",
                                             "skin_toughness",  "skin_tensile_strength",
                                             "sleeps",          "wall_coarsening",
                                             "debris_volume",   "open_cut",
                                             "cut_search"};
    // Steps may end at the same iteration, or have no depth to let out.
    const std::set<std::string_view> seldom{"iteration_error", "depenetration_speed"};
    for (const ParamInfo& info : paramTable()) {
        SCOPED_TRACE(info.name);
        simulation.goTo(then);
        const ParamValue value = draggedValue(simulation.params(), info);
        ASSERT_EQ(simulation.execute(SetParam{std::string(info.name), value}), "");
        step(simulation, 5);
        if (!seldom.contains(info.name)) {
            EXPECT_EQ(simulation.stateHash() == unchanged, waiting.contains(info.name));
        }
        EXPECT_EQ(checkFinite(simulation.mesh()), "");
        EXPECT_TRUE(simulation.report().closed);
        EXPECT_NEAR(simulation.report().volumeRatio, 1, info.name == "solver" ? 0.1 : 0.02)
            << "pbd has no volume constraint";
        EXPECT_THAT(simulation.takeMessages(), IsEmpty());
    }
}

// Run by the next test in child processes.
TEST_F(SimulationTest, PrintsTheHashOfACut) {
    const std::string hash = hashOfACut();
    EXPECT_EQ(hash.size(), 16u);
    std::printf("hash %s\n", hash.c_str());
}

std::string hashWithThreads(const char* threads) {
    const std::string self = fs::read_symlink("/proc/self/exe");
    const std::string command = std::string("LP_NUM_THREADS=") + threads +
                                " GTEST_TOTAL_SHARDS=1 GTEST_SHARD_INDEX=0 '" + self +
                                "' --gtest_filter=SimulationTest.PrintsTheHashOfACut";
    FILE* pipe = popen(command.c_str(), "r");
    std::string hash;
    char line[256];
    while (std::fgets(line, sizeof line, pipe)) {
        char found[17] = {};
        if (std::sscanf(line, "hash %16s", found) == 1) {
            hash = found;
        }
    }
    return pclose(pipe) == 0 ? hash : "";
}

TEST_F(SimulationTest, TheNumberOfThreadsChangesNoBit) {
    const std::string expected = hashOfACut();
    EXPECT_EQ(hashOfACut(), expected) << "in the same process";
    for (const char* threads : {"1", "3"}) {
        EXPECT_EQ(hashWithThreads(threads), expected) << threads << " threads";
    }
}

}  // namespace
}  // namespace kerf
