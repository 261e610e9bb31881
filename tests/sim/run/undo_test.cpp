// Undo and redo of a running simulation, compared bit for bit.
#include <malloc.h>

namespace kerf {
namespace {

constexpr std::size_t kRoom = std::size_t{1} << 30;

Params fallingDeep() {
    Params params;
    params.iterations = 4;
    params.floor = -0.8;
    return params;
}

Blade bladeAt(double x, double y) {
    return {{x, y, -1}, {x, y, 1}};
}

class UndoTest : public SimulationFixture {
  protected:
    void SetUp() override {
        SimulationFixture::SetUp();
        simulation.emplace(cubeSphere(6, 0.5), fallingDeep());
        simulation->setUndoBudget(kRoom);
    }
    /// Down through the body at x; the first `steps` of 30 steps of it.
    void stroke(double x, int steps = 30) {
        for (int i = 0; i <= steps; ++i) {
            ASSERT_EQ(simulation->execute(MoveBlade{bladeAt(x, 0.7 - 1.5 * i / 30)}), "");
            simulation->step();
        }
    }
    void cutAt(double x) {
        stroke(x);
        simulation->execute(LiftBlade{});
        simulation->step();
    }
    void undo() { EXPECT_EQ(simulation->execute(Undo{}), ""); }
    void redo() { EXPECT_EQ(simulation->execute(Redo{}), ""); }
    int pieces() { return static_cast<int>(simulation->pieces().pieces.size()); }
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const UndoEntry& entry : simulation->history().entries()) {
            names.push_back(entry.name);
        }
        return names;
    }
};

TEST_F(UndoTest, ACutIsTakenBackAndBroughtBackToTheBit) {
    run(5);
    cutAt(0.03);
    ASSERT_EQ(pieces(), 2);
    run(5);
    const std::string cut = simulation->stateHash();
    undo();
    EXPECT_EQ(pieces(), 1);
    EXPECT_EQ(simulation->report().pieces, 1);
    EXPECT_EQ(simulation->report().triangles, 432);
    const std::string whole = simulation->stateHash();
    redo();
    EXPECT_EQ(simulation->stateHash(), cut);
    EXPECT_EQ(simulation->report().pieces, 2);
    undo();
    EXPECT_EQ(simulation->stateHash(), whole);
}

TEST_F(UndoTest, WhatFollowsAnUndoIsWhatWouldHaveFollowedWithoutTheCut) {
    // A cut is undone to the moment at which the blade came near the body: here the second step.
    const auto hashAfter = [&](bool withAnUndoneCut) {
        simulation->reset();
        simulation->execute(SetParam{"gravity", Vec3(Vec3::Zero())});
        cutAt(0.2);
        if (withAnUndoneCut) {
            for (const double y : {0.7, 0.3, -0.1, -0.9}) {
                simulation->execute(MoveBlade{bladeAt(0, y)});
                simulation->step();
            }
            EXPECT_EQ(pieces(), 3);
            undo();
        } else {
            run(2);
        }
        run(3);
        cutAt(-0.1);
        run(3);
        EXPECT_EQ(pieces(), 3);
        return simulation->stateHash();
    };
    EXPECT_EQ(hashAfter(true), hashAfter(false));
}

TEST_F(UndoTest, GoingToAMomentAndOnGivesTheSameBits) {
    simulation->execute(SetParam{"iterations", 3.0});
    cutAt(0.2);
    stroke(-0.1, 15);
    const Checkpoint middle = simulation->checkpoint();
    const std::string then = simulation->stateHash();
    const auto goOn = [&] {
        for (int i = 16; i <= 30; ++i) {
            simulation->execute(MoveBlade{bladeAt(-0.1, 0.7 - 1.5 * i / 30)});
            simulation->step();
        }
        simulation->execute(Undo{});
        simulation->execute(Redo{});
        run(2);
        return simulation->stateHash();
    };
    const std::string end = goOn();
    const int steps = simulation->stepCount();
    simulation->reset();
    simulation->goTo(middle);
    EXPECT_EQ(simulation->stateHash(), then);
    EXPECT_EQ(simulation->params().iterations, 3);
    EXPECT_THAT(names(), ElementsAre("Iterations: 3", "Cut 1", "Cut 2"));
    EXPECT_TRUE(simulation->blade());
    EXPECT_EQ(goOn(), end);
    EXPECT_EQ(simulation->stepCount(), steps);
}

// The step in which a stroke begins notes the body before the stroke, for undo.
TEST_F(UndoTest, AMomentAfterAnyStepOfAStrokeGoesOnAsItDid) {
    const auto stepTo = [&](int i) {
        const double y = 0.7 - 0.3 * i;
        simulation->execute(MoveBlade{{{0.03, y, -1}, {0.03, y, 1}}});
        simulation->step();
        return simulation->stateHash();
    };
    for (int i = 0; i < 5; ++i) {
        SCOPED_TRACE(i);
        const std::string here = stepTo(i);
        const Checkpoint then = simulation->checkpoint();
        const std::string next = stepTo(i + 1);
        simulation->goTo(then);
        EXPECT_EQ(simulation->stateHash(), here);
        EXPECT_EQ(stepTo(i + 1), next);
        simulation->goTo(then);
    }
}

// What may touch is kept over several steps.
TEST_F(UndoTest, GoingToAMomentKeepsContacts) {
    simulation->execute(SetParam{"contact", 1.0});
    cutAt(0.03);
    const auto expectTheSameAgain = [&] {
        const Checkpoint then = simulation->checkpoint();
        run(4);
        const std::string end = simulation->stateHash();
        simulation->goTo(then);
        run(4);
        EXPECT_EQ(simulation->stateHash(), end) << simulation->stepCount();
    };
    for (int i = 0; i < 5; ++i) {
        expectTheSameAgain();
        run(5);
    }
    EXPECT_GT(simulation->report().contacts, 0);
}

// There contact goes by the diagonal, and a cut may take the outermost vertices away.
TEST_F(UndoTest, ACoarseBodyGoesOnWithTheSameBits) {
    Params soft;
    soft.floor = -0.6;
    soft.youngsModulus = 2e4;
    const auto hashAfter = [&](bool withUndo) {
        simulation.emplace(builtin("sphere80"), soft);
        simulation->setUndoBudget(kRoom);
        run(5);
        EXPECT_EQ(simulation->execute(MoveBlade{{{0.1, 0.8, -0.9}, {0.12, 0.8, 0.9}}}), "");
        run(25);
        EXPECT_EQ(simulation->execute(MoveBlade{{{-0.1, -0.9, -0.9}, {-0.08, -0.9, 0.9}}}), "");
        simulation->step();
        EXPECT_EQ(simulation->execute(LiftBlade{}), "");
        simulation->step();
        EXPECT_EQ(pieces(), 2);
        if (withUndo) {
            undo();
            redo();
        }
        run(8);
        return simulation->stateHash();
    };
    EXPECT_EQ(hashAfter(true), hashAfter(false));
}

TEST_F(UndoTest, SnapshotBytesAreAboutWhatTheHeapGives) {
    simulation.emplace(cubeSphere(40, 0.5), fallingDeep());
    simulation->setUndoBudget(kRoom);
    simulation->mesh();
    const auto inUse = [] { return ::mallinfo2().uordblks + ::mallinfo2().hblkhd; };
    if (inUse() == 0) {
        GTEST_SKIP() << "this heap does not count";
    }
    simulation->execute(Restart{});  // now the body is a copy too, without room to spare
    const std::size_t bytesBefore = simulation->history().bytes();
    const std::size_t before = inUse();
    for (int i = 0; i < 4; ++i) {  // so that what drivers take and free meanwhile weighs little
        simulation->execute(Restart{});
    }
    const double taken = static_cast<double>(inUse() - before);
    const std::size_t estimated = simulation->history().bytes() - bytesBefore;
    std::printf("bytes by heap: %.0f, estimated: %zu\n", taken, estimated);
    EXPECT_NEAR(static_cast<double>(estimated) / taken, 1, 0.3);
}

TEST_F(UndoTest, AStrokeInItsMiddleIsEndedAndTakenBack) {
    const std::string whole = simulation->stateHash();
    simulation->execute(SetParam{"gravity", Vec3(Vec3::Zero())});
    stroke(0.03, 14);
    EXPECT_NE(simulation->stateHash(), whole);
    undo();
    EXPECT_FALSE(simulation->blade());
    EXPECT_EQ(simulation->report().triangles, 432);
    redo();
    EXPECT_GT(simulation->report().triangles, 432);
    EXPECT_TRUE(simulation->report().closed);
    EXPECT_FALSE(simulation->blade());
    cutAt(-0.2);
    EXPECT_EQ(pieces(), 2);
}

TEST_F(UndoTest, ABladeThatMissesLeavesNothingToUndo) {
    cutAt(0.7);
    EXPECT_EQ(simulation->execute(Undo{}), "There is nothing to undo.");
    EXPECT_EQ(simulation->execute(Redo{}), "There is nothing to redo.");
}

TEST_F(UndoTest, ParametersAndCutsFormOneRow) {
    simulation->execute(SetParam{"time_step", 0.004});
    simulation->execute(SetParam{"time_step", 0.003, true});
    simulation->execute(SetParam{"time_step", 0.002, true});
    cutAt(0.03);
    simulation->execute(SetParam{"floor", std::monostate{}});
    EXPECT_THAT(names(), ElementsAre("Time step: 0.002 s", "Cut 1", "Floor: none"));
    undo();
    EXPECT_EQ(simulation->params().floor, -0.8);
    EXPECT_EQ(pieces(), 2);
    undo();
    EXPECT_EQ(pieces(), 1);
    undo();
    EXPECT_EQ(simulation->params().timeStep, 0.005);
    redo();
    redo();
    EXPECT_EQ(simulation->params().timeStep, 0.002);
    EXPECT_EQ(pieces(), 2);
    simulation->execute(SetParam{"iterations", 7.0});
    EXPECT_EQ(simulation->execute(Redo{}), "There is nothing to redo.")
        << "a new change ends what was undone";
}

TEST_F(UndoTest, AMaterialIsOneChangeHoweverManyParametersItSets) {
    const Params before = simulation->params();
    simulation->execute(SetParam{"density", 1040.0, false, "Brain"});
    simulation->execute(SetParam{"youngs_modulus", 1640.0, false, "Brain"});
    simulation->execute(SetParam{"friction", 0.2, false, "Brain"});
    const Params brain = simulation->params();
    simulation->execute(SetParam{"density", 950.0, false, "Rubber"});
    simulation->execute(SetParam{"density", 960.0, false, "Rubber"});
    simulation->execute(SetParam{"density", 970.0});
    EXPECT_THAT(names(), ElementsAre("Material: Brain", "Material: Rubber", "Density: 970 kg/m^3"));
    undo();
    EXPECT_EQ(simulation->params().density, 960);
    undo();
    EXPECT_EQ(simulation->params(), brain);
    undo();
    EXPECT_EQ(simulation->params(), before);
    redo();
    EXPECT_EQ(simulation->params(), brain);
    redo();
    EXPECT_EQ(simulation->params().density, 960);
}

// Here what the blade has swept is cut where it is put away.
TEST_F(UndoTest, AStrokeThatEndsForARedoIsAChangeOfItsOwn) {
    simulation->execute(SetParam{"gravity", Vec3(Vec3::Zero())});
    undo();
    for (const double y : {0.1, 0.09}) {
        simulation->execute(MoveBlade{bladeAt(0.03, y)});
        simulation->step();
    }
    ASSERT_TRUE(simulation->history().canRedo());
    EXPECT_EQ(simulation->execute(Redo{}), "There is nothing to redo.");
    EXPECT_THAT(names(), ElementsAre("Cut 1"));
    undo();
    EXPECT_EQ(simulation->report().triangles, 432);
}

TEST_F(UndoTest, ARestartCanBeTakenBackAndTimeGoesOn) {
    cutAt(0.03);
    const std::string cut = simulation->stateHash();
    const int steps = simulation->stepCount();
    simulation->execute(Restart{});
    EXPECT_EQ(simulation->stateHash(), Simulation(cubeSphere(6, 0.5), fallingDeep()).stateHash());
    EXPECT_EQ(simulation->stepCount(), steps);
    undo();
    EXPECT_EQ(simulation->stateHash(), cut);
}

TEST_F(UndoTest, ARestartedBodyIsCutAsANewOne) {
    cutAt(-0.2);
    const std::string cut = simulation->stateHash();
    simulation.emplace(cubeSphere(6, 0.5), fallingDeep());
    simulation->setUndoBudget(kRoom);
    cutAt(0.03);
    simulation->execute(Restart{});
    cutAt(-0.2);
    EXPECT_EQ(simulation->stateHash(), cut);
}

TEST_F(UndoTest, ABodyTooLargeForTheBudgetEndsWhatCanBeUndone) {
    simulation->setUndoBudget(1000);
    simulation->execute(SetParam{"iterations", 7.0});
    EXPECT_TRUE(simulation->history().canUndo());
    cutAt(0.03);
    EXPECT_EQ(pieces(), 2);
    EXPECT_FALSE(simulation->history().canUndo()) << "that would leave the cut in";
    EXPECT_EQ(simulation->history().forgotten(), 2);
    const auto tellsSo = [](const std::string& message) {
        return message.find("can't be undone") != std::string::npos;
    };
    EXPECT_EQ(std::ranges::count_if(simulation->takeMessages(), tellsSo), 1);
    simulation->execute(Restart{});
    EXPECT_EQ(std::ranges::count_if(simulation->takeMessages(), tellsSo), 0) << "once is enough";
    EXPECT_EQ(simulation->history().forgotten(), 3);
    simulation->execute(SetParam{"iterations", 8.0});
    undo();
    EXPECT_EQ(simulation->params().iterations, 7);
}

TEST_F(UndoTest, BoxesAndPinsCountForTheBudget) {
    const StaticBox box{Vec3(0, -3, 0), Vec3::Ones(), Vec3::Zero()};
    simulation->setUndoBudget(20 * sizeof(StaticBox));
    for (int i = 0; i < 40; ++i) {
        EXPECT_EQ(simulation->execute(AddBox{box}), "");
    }
    EXPECT_LE(simulation->history().bytes(), 20 * sizeof(StaticBox));
    EXPECT_EQ(simulation->boxes().size(), 40U);
    simulation->setUndoBudget(kRoom);
    const std::size_t before = simulation->history().bytes();
    EXPECT_EQ(simulation->execute(Pin{simulation->bounds()}), "");
    EXPECT_GT(simulation->history().bytes(), before);
}

TEST_F(UndoTest, TheBudgetForgetsTheOldestFirst) {
    cutAt(0.2);
    cutAt(-0.2);
    const std::size_t used = simulation->history().bytes();
    EXPECT_GT(used, 0U);
    simulation->setUndoBudget(used - 1);
    EXPECT_THAT(names(), ElementsAre("Cut 2"));
    EXPECT_EQ(simulation->history().forgotten(), 1);
    undo();
    EXPECT_EQ(pieces(), 2);
    EXPECT_EQ(simulation->execute(Undo{}), "There is nothing to undo.");
}

TEST_F(UndoTest, WithoutABudgetNothingIsKeptAndTheBitsAreTheSame) {
    cutAt(0.03);
    Simulation plain(cubeSphere(6, 0.5), fallingDeep());
    const std::string kept = simulation->stateHash();
    std::optional<Simulation> other(std::move(plain));
    simulation.swap(other);
    cutAt(0.03);
    EXPECT_EQ(simulation->stateHash(), kept);
    EXPECT_EQ(simulation->execute(Undo{}), "There is nothing to undo.");
    simulation.swap(other);
}

TEST_F(UndoTest, PinsOfOneGestureAreTakenBackTogether) {
    const auto pinned = [&] { return simulation->pinnedVertices(); };
    ASSERT_EQ(simulation->execute(Pin{Ball{{0.5, 0, 0}, 0.2}}), "");
    const auto first = pinned();
    ASSERT_EQ(simulation->execute(Pin{Ball{{-0.5, 0, 0}, 0.2}}), "");
    ASSERT_EQ(simulation->execute(Pin{Ball{{0, 0, 0.5}, 0.2}, true, true}), "");
    const auto all = pinned();
    EXPECT_EQ(names(), (std::vector<std::string>{"Pin", "Pin"}));
    run(3);
    undo();
    EXPECT_EQ(pinned(), first);
    undo();
    EXPECT_TRUE(pinned().empty());
    redo();
    redo();
    EXPECT_EQ(pinned(), all);
}

// The change of pins comes after that of the cut, which goes on: copies are pinned and freed too.
TEST_F(UndoTest, PinsMadeInMidStrokeFollowTheRestOfIt) {
    const auto pinned = [&] { return simulation->pinnedVertices(); };
    stroke(0.03, 10);
    ASSERT_EQ(simulation->execute(Pin{Ball{{0, 0, -0.5}, 0.3}}), "");
    const auto first = pinned();
    ASSERT_EQ(simulation->execute(Pin{Ball{{0, 0, 0.5}, 0.3}}), "");
    makeStroke(*simulation, bladeAt(0.03, 0.15), bladeAt(0.03, -0.8), 19);
    ASSERT_EQ(pieces(), 2);
    EXPECT_EQ(names(), (std::vector<std::string>{"Cut 1", "Pin", "Pin"}));
    const std::string hash = simulation->stateHash();
    const auto all = pinned();
    undo();
    const auto followed = pinned();
    EXPECT_GT(followed.size(), first.size()) << "with copies";
    EXPECT_TRUE(std::ranges::includes(followed, first));
    EXPECT_LT(followed.size(), all.size());
    undo();
    EXPECT_TRUE(pinned().empty());
    redo();
    EXPECT_EQ(pinned(), followed);
    redo();
    EXPECT_EQ(pinned(), all);
    EXPECT_EQ(simulation->stateHash(), hash);
}

TEST_F(UndoTest, APullIsTakenBackToWhereItTookHold) {
    run(3);
    const std::string before = simulation->stateHash();
    ASSERT_EQ(simulation->execute(Grab{0, Vec3(0.5, 0, 0), 0.3}), "");
    simulation->execute(Drag{0, Vec3(0.9, 0, 0)});
    run(5);
    simulation->execute(Release{0});
    const std::string after = simulation->stateHash();
    undo();
    EXPECT_EQ(simulation->stateHash(), before);
    EXPECT_TRUE(simulation->hands().empty());
    redo();
    EXPECT_EQ(simulation->stateHash(), after);
}

}  // namespace
}  // namespace kerf
