// Hands that pull and pins that hold, as commands of a simulation.

namespace kerf {
namespace {

class HandlesTest : public GlTest {};

TEST_F(HandlesTest, AHandPullsTheBodyAlongAndLetsGo) {
    Params params = weightless();
    params.airDrag = 10;
    Simulation simulation(icosphere(2), params);
    ASSERT_EQ(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0.2}), "");
    const std::size_t held = simulation.hands().at(0).held.size();
    EXPECT_GT(held, 2u);
    EXPECT_LT(held, 30u);
    for (int step = 1; step <= 40; ++step) {
        ASSERT_EQ(simulation.execute(Drag{0, Vec3(0.5 + 0.01 * step, 0, 0)}), "");
        simulation.step();
    }
    step(simulation, 150);
    EXPECT_NEAR(middleOf(simulation.mesh()).x(), 0.4, 0.05);
    for (const Hands::Held& each : simulation.hands().at(0).held) {
        const Vec3 wanted = Vec3(0.9, 0, 0) + each.offset;
        EXPECT_LT((simulation.mesh().position(each.vertex) - wanted).norm(), 0.02);
    }
    ASSERT_EQ(simulation.execute(Release{0}), "");
    EXPECT_TRUE(simulation.hands().empty());
}

TEST_F(HandlesTest, TwoHandsPullABodyApartAndItComesBack) {
    Simulation simulation(icosphere(2), weightless());
    ASSERT_EQ(simulation.execute(Grab{1, Vec3(0.5, 0, 0), 0.25}), "");
    ASSERT_EQ(simulation.execute(Grab{2, Vec3(-0.5, 0, 0), 0.25}), "");
    for (int step = 1; step <= 20; ++step) {
        simulation.execute(Drag{1, Vec3(0.5 + 0.01 * step, 0, 0)});
        simulation.execute(Drag{2, Vec3(-0.5 - 0.01 * step, 0, 0)});
        simulation.step();
    }
    step(simulation, 40);
    const auto width = [&] { return simulation.bounds().high.x() - simulation.bounds().low.x(); };
    EXPECT_GT(width(), 1.3);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
    simulation.execute(Release{1});
    simulation.execute(Release{2});
    step(simulation, 150);
    EXPECT_NEAR(width(), 1, 0.05);
}

TEST_F(HandlesTest, PinnedVerticesHoldTheBodyUp) {
    Params params = weightless();
    params.gravity = Vec3(0, -9.81, 0);
    Simulation simulation(icosphere(2), params);
    ASSERT_EQ(simulation.execute(Pin{Bounds{{-1, 0.35, -1}, {1, 1, 1}}, true}), "");
    const std::vector<std::uint32_t> pinned = simulation.pinnedVertices();
    ASSERT_GT(pinned.size(), 3u);
    const SurfaceMesh before = simulation.mesh();
    step(simulation, 100);
    for (const std::uint32_t v : pinned) {
        const int vertex = static_cast<int>(v);
        EXPECT_EQ(simulation.mesh().position(vertex), before.position(vertex));
    }
    EXPECT_GT(middleOf(simulation.mesh()).y(), -0.3);
    EXPECT_LT(middleOf(simulation.mesh()).y(), -0.001) << "it sags";
    ASSERT_EQ(simulation.execute(Pin{Ball{{0, 0.5, 0}, 2}, false}), "");
    EXPECT_TRUE(simulation.pinnedVertices().empty());
    step(simulation, 60);
    EXPECT_LT(middleOf(simulation.mesh()).y(), -0.3) << "it falls";
}

TEST_F(HandlesTest, CopiesOfPinnedVerticesThatACutMakesStayPinned) {
    Simulation simulation(icosphere(2), weightless());
    ASSERT_EQ(simulation.execute(Pin{Ball{Vec3::Zero(), 1}, true}), "");
    const std::size_t before = simulation.pinnedVertices().size();
    makeStroke(simulation, {{-1, 0.7, 0.013}, {1, 0.7, 0.013}},
               {{-1, -0.7, 0.013}, {1, -0.7, 0.013}}, 20);
    ASSERT_EQ(simulation.report().pieces, 2);
    const SurfaceMesh& mesh = simulation.mesh();
    EXPECT_GE(simulation.pinnedVertices().size() + 20, before);
    for (const std::uint32_t v : simulation.pinnedVertices()) {
        ASSERT_GE(mesh.outgoing(static_cast<int>(v)), 0);
        EXPECT_EQ(mesh.velocity(static_cast<int>(v)), Vec3::Zero());
    }
}

/// 0.25 m x 1 m x 0.25 m with even triangles, from y = -1 m to 0; `n` quads across.
SurfaceMesh evenBar(int n) {
    const std::array<int, 3> cells{n, 4 * n, n};
    std::map<std::array<int, 3>, int> numbers;
    TriangleSoup soup;
    const auto corner = [&](std::array<int, 3> at) {
        const auto [found, isNew] = numbers.try_emplace(at, static_cast<int>(numbers.size()));
        if (isNew) {
            soup.positions.push_back(Vec3(at[0] - n / 2.0, at[1] - 4.0 * n, at[2] - n / 2.0) *
                                     (0.25 / n));
        }
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int w = (axis + 2) % 3;
        for (const int side : {0, 1}) {
            for (int i = 0; i < cells[u]; ++i) {
                for (int j = 0; j < cells[w]; ++j) {
                    std::array<int, 4> quad{};
                    for (int k = 0; k < 4; ++k) {
                        std::array<int, 3> at{};
                        at[axis] = side * cells[axis];
                        at[u] = i + (k == 1 || k == 2 ? 1 : 0);
                        at[w] = j + (k >= 2 ? 1 : 0);
                        quad[side == 1 ? k : 3 - k] = corner(at);
                    }
                    const int turn = (i + j) % 2;
                    soup.triangles.push_back({quad[turn], quad[turn + 1], quad[turn + 2]});
                    soup.triangles.push_back({quad[turn], quad[turn + 2], quad[(turn + 3) % 4]});
                }
            }
        }
    }
    return meshOf(soup);
}

/// The mean of what lies at the lower end of a bar that is pinned at its upper one.
double lowerEnd(Simulation& simulation, const Bounds& end) {
    double sum = 0;
    int count = 0;
    const SurfaceMesh& mesh = simulation.mesh();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (contains(end, mesh.restPosition(v))) {
            sum += mesh.position(v).y();
            ++count;
        }
    }
    return sum / count;
}

TEST_F(HandlesTest, ABarStretchesByAForceAsItsModulusSays) {
    Params params = weightless();
    params.iterations = 30;
    params.youngsModulus = 1e5;
    params.damping = 0.005;
    params.airDrag = 2;
    Simulation simulation(evenBar(6), params);
    const Bounds end{{-1, -1, -1}, {1, -0.999, 1}};
    ASSERT_EQ(simulation.execute(Pin{Bounds{{-1, -0.001, -1}, {1, 1, 1}}}), "");
    ASSERT_EQ(simulation.execute(ApplyForce{end, Vec3(0, -200, 0)}), "");
    step(simulation, 400);
    const double stretch = 200 / (1e5 * 0.25 * 0.25);  // F L / (E A)
    EXPECT_NEAR(lowerEnd(simulation, end), -1 - stretch, 0.06 * stretch);
    ASSERT_EQ(simulation.execute(ApplyForce{Ball{{0, 0, 0}, 2}, Vec3::Zero()}), "");
    EXPECT_TRUE(simulation.forces().empty());
    step(simulation, 400);
    EXPECT_NEAR(lowerEnd(simulation, end), -1, 0.06 * stretch);
}

TEST_F(HandlesTest, AFreeBodyIsAcceleratedByItsMass) {
    for (const SolverMode mode : {SolverMode::implicit, SolverMode::pbd}) {
        Params params = weightless();
        params.solver = mode;
        params.airDrag = 0;
        Simulation simulation(icosphere(2), params);
        const std::vector<double> masses = unitMasses(simulation.bodyModel());
        const double mass = params.density * std::accumulate(masses.begin(), masses.end(), 0.0);
        ASSERT_EQ(simulation.execute(ApplyForce{Ball{{0, 0, 0}, 2}, Vec3(mass, 0, 0)}), "");
        step(simulation, 100);
        const double t = 100 * params.timeStep;
        EXPECT_NEAR(middleOf(simulation.mesh()).x(), 0.5 * t * t, 0.02 * t * t);
    }
}

TEST_F(HandlesTest, PinsMoveExactlyAsPrescribedAndThenStay) {
    Params params = weightless();
    params.gravity = Vec3(0, -9.81, 0);
    params.sleeps = 1;
    Simulation simulation(icosphere(2), params);
    const Vec3 velocity(2e-5, 0.03, -0.01);  // slower than a body that sleeps, along x
    Pin pin{Bounds{{-1, 0.35, -1}, {1, 1, 1}}};
    pin.velocity = velocity;
    pin.seconds = 100.5 * params.timeStep;
    const SurfaceMesh before = simulation.mesh();
    ASSERT_EQ(simulation.execute(pin), "");
    const auto expectMoved = [&](double seconds) {
        for (const std::uint32_t v : simulation.pinnedVertices()) {
            const int vertex = static_cast<int>(v);
            const Vec3 there = before.position(vertex) + seconds * velocity;
            EXPECT_LT((simulation.mesh().position(vertex) - there).norm(), 2e-6);
        }
    };
    step(simulation, 60);
    expectMoved(60 * params.timeStep);
    step(simulation, 100);
    expectMoved(*pin.seconds);
    for (const std::uint32_t v : simulation.pinnedVertices()) {
        EXPECT_EQ(simulation.mesh().velocity(static_cast<int>(v)), Vec3::Zero());
    }
}

TEST_F(HandlesTest, ForcesAndMotionsFollowACutAndAreTakenBack) {
    Simulation simulation(icosphere(2), weightless());
    simulation.setUndoBudget(std::size_t{1} << 30);
    ASSERT_EQ(simulation.execute(ApplyForce{Ball{{0.5, 0, 0}, 0.4}, Vec3(1, 0, 0)}), "");
    Pin pin{Ball{{-0.5, 0, 0}, 0.4}};
    pin.velocity = Vec3(-0.01, 0, 0);
    ASSERT_EQ(simulation.execute(pin), "");
    const std::size_t pushed = simulation.forces().at(0).held.vertices().size();
    const std::size_t pinned = simulation.pinnedVertices().size();
    leadBlade(simulation, {{-1, 0.7, 0.013}, {1, 0.7, 0.013}},
              {{-1, -0.7, 0.013}, {1, -0.7, 0.013}}, 20);
    simulation.execute(LiftBlade{});
    step(simulation, 3);
    ASSERT_EQ(simulation.report().pieces, 2);
    EXPECT_GE(simulation.forces().at(0).held.vertices().size(), pushed);
    EXPECT_GE(simulation.pinnedVertices().size(), pinned);
    for (const std::uint32_t v : simulation.forces().at(0).held.vertices()) {
        ASSERT_GE(simulation.mesh().outgoing(static_cast<int>(v)), 0);
    }
    EXPECT_EQ(simulation.execute(Undo{}), "");
    EXPECT_EQ(simulation.execute(Undo{}), "");
    EXPECT_TRUE(simulation.pinnedVertices().empty());
    EXPECT_EQ(simulation.execute(Undo{}), "");
    EXPECT_TRUE(simulation.forces().empty());
    EXPECT_EQ(simulation.execute(Redo{}), "");
    EXPECT_EQ(simulation.forces().at(0).newtons, Vec3(1, 0, 0));
    step(simulation, 2);
}

TEST_F(HandlesTest, MistakesAreOneSentenceAndChangeNothing) {
    Simulation simulation(icosphere(1), weightless());
    const std::string hash = simulation.stateHash();
    EXPECT_THAT(simulation.execute(Grab{0, Vec3(5, 0, 0), 0.1}), HasSubstr("No free vertex"));
    EXPECT_THAT(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0}), HasSubstr("radius"));
    EXPECT_THAT(simulation.execute(Drag{3, Vec3::Zero()}), HasSubstr("Hand 3 holds nothing"));
    EXPECT_THAT(simulation.execute(Release{0}), HasSubstr("Hand 0 holds nothing"));
    EXPECT_THAT(simulation.execute(Pin{Ball{{9, 9, 9}, 1}, true}), HasSubstr("nothing was pinned"));
    EXPECT_THAT(simulation.execute(Pin{Ball{{0, 0, 0}, 9}, false}), HasSubstr("nothing was freed"));
    EXPECT_THAT(simulation.execute(ApplyForce{Ball{{9, 9, 9}, 1}, {1, 0, 0}}),
                HasSubstr("nothing was changed"));
    EXPECT_THAT(simulation.execute(ApplyForce{Ball{{0, 0, 0}, 9}, {0, 0, 0}}),
                HasSubstr("No force acts"));
    EXPECT_EQ(simulation.stateHash(), hash);
    EXPECT_TRUE(simulation.hands().empty());
    EXPECT_TRUE(simulation.pinnedVertices().empty());
}

// What moves, by an empty list, kept a body from sleeping, but not in its replay.
TEST_F(HandlesTest, AMotionOfNothingLeavesNothingBehind) {
    Simulation simulation(icosphere(1), weightless());
    const auto before = bytesOf(simulation.checkpoint());
    Pin pin{Ball{{9, 9, 9}, 1}};
    pin.velocity = Vec3(1, 0, 0);
    EXPECT_THAT(simulation.execute(pin), HasSubstr("nothing was pinned"));
    EXPECT_EQ(bytesOf(simulation.checkpoint()), before);
}

TEST_F(HandlesTest, AHandThatHoldsAgainLetsGoOfWhatItHeld) {
    Simulation simulation(icosphere(2), weightless());
    ASSERT_EQ(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0.2}), "");
    ASSERT_EQ(simulation.execute(Grab{0, Vec3(0.5, 0, 0), 0.2}), "") << "its own are free";
    EXPECT_EQ(simulation.hands().size(), 1u);
    EXPECT_THAT(simulation.execute(Grab{1, Vec3(0.5, 0, 0), 0.2}), HasSubstr("No free vertex"));
}

TEST_F(HandlesTest, ALostPieceIsTakenBackAndSaidOnce) {
    Simulation simulation(icosphere(1), weightless());
    // To a speed that nothing real reaches.
    ASSERT_EQ(simulation.execute(ApplyForce{Ball{{0.5, 0, 0}, 0.3}, Vec3(1e12, 0, 0)}), "");
    EXPECT_EQ(simulation.step().lostPieces, 1);
    EXPECT_EQ(simulation.step().lostPieces, 1) << "the force still acts";
    const std::vector<std::string> messages = simulation.takeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_THAT(messages[0], HasSubstr("1 piece of 1 left the range of numbers"));
    EXPECT_LT(middleOf(simulation.mesh()).norm(), 1e-3);
    ASSERT_EQ(simulation.execute(ApplyForce{Ball{{0.5, 0, 0}, 0.3}, Vec3::Zero()}), "");
    EXPECT_EQ(simulation.step().lostPieces, 0);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
}

}  // namespace
}  // namespace kerf
