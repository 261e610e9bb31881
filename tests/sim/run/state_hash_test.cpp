#include "sim/run/state_hash.h"

namespace kerf {
namespace {

TEST(StateHash, IsFnv1aOfLittleEndianWords) {
    StateHash hash;
    EXPECT_EQ(hash.hexadecimal(), "cbf29ce484222325");
    hash.add(0x64636261u);  // "abcd"
    EXPECT_EQ(hash.hexadecimal(), "fc179f83ee0724dd");
    hash.add(0x68676665u);  // "efgh"
    EXPECT_EQ(hash.value(), 0x25da8c1836a8d66dull);
}

TEST(StateHash, SeesEveryPartOfTheState) {
    const SurfaceMesh mesh = icosphere(1);
    const std::string before = hashMesh(mesh).hexadecimal();
    EXPECT_EQ(hashMesh(icosphere(1)).hexadecimal(), before);

    SurfaceMesh moved = mesh;
    moved.setPosition(5, mesh.position(5) + Vec3(1e-6, 0, 0));
    EXPECT_NE(hashMesh(moved).hexadecimal(), before);

    SurfaceMesh pushed = mesh;
    pushed.setVelocity(5, Vec3(0, 0, 1e-20));
    EXPECT_NE(hashMesh(pushed).hexadecimal(), before);

    SurfaceMesh turned = mesh;
    const Triangle corners = mesh.triangle(3);
    for (int k = 0; k < 3; ++k) {
        turned.setCorner(3, k, corners[(k + 1) % 3]);
    }
    EXPECT_NE(hashMesh(turned).hexadecimal(), before);
}

TEST(StateHash, SeesBoxesWhereThereAreAny) {
    const SurfaceMesh mesh = icosphere(1);
    std::vector<StaticBox> boxes(1);
    const std::string before = hashScene(mesh, boxes).hexadecimal();
    EXPECT_EQ(hashScene(mesh, {}).hexadecimal(), hashMesh(mesh).hexadecimal());
    EXPECT_NE(before, hashMesh(mesh).hexadecimal());
    boxes[0].rotate.z() = 1e-6;
    EXPECT_NE(hashScene(mesh, boxes).hexadecimal(), before);
}

/// The parts in which two states differ.
std::vector<StatePart> differingParts(const StateHashes& a, const StateHashes& b) {
    std::vector<StatePart> parts;
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        if (a.parts[i] != b.parts[i]) {
            parts.push_back(static_cast<StatePart>(i));
        }
    }
    return parts;
}

TEST(StateHash, EachPartHasItsOwn) {
    const SurfaceMesh mesh = icosphere(1);
    const std::vector<StaticBox> boxes(1);
    const Blade blade{{0, 0, 0}, {1, 0, 0}};
    const StateHashes before = hashParts(mesh, boxes, {}, blade);
    EXPECT_EQ(before.state, hashScene(mesh, boxes).hexadecimal());

    using Parts = std::vector<StatePart>;
    SurfaceMesh moved = mesh;
    moved.setPosition(5, mesh.position(5) + Vec3(1e-6, 0, 0));
    EXPECT_EQ(differingParts(hashParts(moved, boxes, {}, blade), before),
              Parts{StatePart::positions});
    SurfaceMesh pushed = mesh;
    pushed.setVelocity(5, Vec3(0, 0, 1e-20));
    EXPECT_EQ(differingParts(hashParts(pushed, boxes, {}, blade), before),
              Parts{StatePart::velocities});
    SurfaceMesh turned = mesh;
    turned.setCorner(3, 0, mesh.triangle(3)[1]);
    EXPECT_EQ(differingParts(hashParts(turned, boxes, {}, blade), before),
              Parts{StatePart::topology});
    EXPECT_EQ(differingParts(hashParts(mesh, {}, {}, blade), before), Parts{StatePart::boxes});
    EXPECT_EQ(differingParts(hashParts(mesh, boxes, {}, std::nullopt), before),
              Parts{StatePart::blade});
    EXPECT_EQ(differingParts(hashParts(mesh, boxes, {}, Blade{{1e-17, 0, 0}, {1, 0, 0}}), before),
              Parts{StatePart::blade});
}

TEST(StateHash, SeesEveryParameterThatChangesStates) {
    const SurfaceMesh mesh = icosphere(0);
    Params tearing;
    tearing.tearing = 1;  // without it strengths wait
    const StateHashes before = hashParts(mesh, {}, tearing, std::nullopt);
    for (const ParamInfo& info : paramTable()) {
        const ParamValue now = getParam(tearing, info.name);
        ParamValue other = info.type == ParamType::choice
                               ? ParamValue(std::string(info.choices.back()))
                           : info.type == ParamType::vector ? ParamValue(Vec3(0, 0, info.high))
                                                            : ParamValue(info.high);
        if (other == now) {
            other = info.type == ParamType::choice ? ParamValue(std::string(info.choices.front()))
                                                   : ParamValue(info.low);
        }
        Params changed = tearing;
        ASSERT_EQ(setParam(changed, info.name, other), "") << info.name;
        EXPECT_EQ(
            differingParts(hashParts(mesh, {}, changed, std::nullopt), before),
            info.changesStates ? std::vector{StatePart::parameters} : std::vector<StatePart>{})
            << info.name;
    }
    EXPECT_FALSE(findParam("cut_search")->changesStates);
}

TEST(StateHash, IsThatOfOldRunsWhereTheBodyDoesNotTear) {
    const SurfaceMesh mesh = icosphere(0);
    Params strong;
    strong.tensileStrength = 1e6;
    strong.skinToughness = 7;
    strong.skinStrength = 1e7;
    EXPECT_EQ(differingParts(hashParts(mesh, {}, strong, std::nullopt),
                             hashParts(mesh, {}, {}, std::nullopt)),
              std::vector<StatePart>{});
}

TEST(StateHash, RoundsToFloat) {
    const SurfaceMesh mesh = icosphere(1);
    SurfaceMesh rounded = mesh;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        rounded.setPosition(v, nearestFloats(mesh.position(v)));
    }
    EXPECT_EQ(hashMesh(rounded).hexadecimal(), hashMesh(mesh).hexadecimal());
}

// Moments that another simulation continues from: bit for bit, as if it had done it all.

using Bytes = std::vector<std::byte>;

/// All that a moment has to carry: auto iterations, sleep, contact.
Params newScene(SolverMode solver = SolverMode::implicit) {
    Params params;
    params.solver = solver;
    params.iterations = kAutoIterations;
    params.sleeps = 1;
    params.floor = -0.6;
    params.youngsModulus = 2e4;
    params.wallCoarsening = 3;
    return params;
}

/// The same random work for several simulations.
class Work {
  public:
    explicit Work(unsigned seed) : random_(seed) {}

    /// A stroke, then some steps.
    void cut(Simulation& simulation) {
        const double x = uniform(-0.35, 0.35);
        const double slant = uniform(-0.2, 0.2);
        const double depth = uniform(0.2, 1.6);
        leadBlade(simulation, {{x, 0.8, -1}, {x + slant, 0.8, 1}},
                  {{x, 0.8 - depth, -1}, {x + slant, 0.8 - depth, 1}}, 12);
        simulation.execute(LiftBlade{});
        for (int left = std::uniform_int_distribution(1, 12)(random_); left > 0; --left) {
            simulation.step();
        }
    }
    /// One of the other things that people do.
    void change(Simulation& simulation) {
        switch (std::uniform_int_distribution(0, 4)(random_)) {
            case 0:
                simulation.execute(SetParam{"youngs_modulus", uniform(1e4, 1e5)});
                break;
            case 1:
                simulation.execute(Grab{60, {uniform(-0.4, 0.4), 0.4, 0}, 0.2});
                simulation.execute(Drag{60, {0.3, 0.9, 0}});
                break;
            case 2:
                simulation.execute(Pin{Ball{{0.4, uniform(-0.3, 0.3), 0}, 0.2}, true});
                break;
            case 3:
                simulation.execute(AddBox{{{uniform(-0.5, 0.5), -0.5, 0}, {0.2, 0.2, 0.2}}});
                break;
            default:
                simulation.execute(SetParam{"ispc_stiffness", uniform(0, 1)});
                break;
        }
    }

  private:
    double uniform(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }

    std::mt19937 random_;
};

class StoredMomentTest : public SimulationFixture {
  protected:
    static Simulation begun(SolverMode solver = SolverMode::implicit) {
        return {cubeSphere(6, 0.5), newScene(solver)};
    }
    static Bytes bytesNow(Simulation& simulation) {
        const std::optional<Bytes> bytes = bytesOf(simulation.checkpoint());
        EXPECT_TRUE(bytes);
        return bytes.value_or(Bytes{});
    }
};

TEST_F(StoredMomentTest, AnotherSimulationContinuesWithTheSameBits) {
    for (unsigned seed = 1; seed <= 9; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const SolverMode solver = seed > 6 ? SolverMode::pbd : SolverMode::implicit;
        Simulation first = begun(solver);
        Work before(seed);
        for (unsigned i = 0; i < seed % 4; ++i) {
            before.cut(first);
            before.change(first);
        }
        Simulation second = begun(solver);
        ASSERT_TRUE(second.goTo(bytesNow(first)));
        EXPECT_EQ(second.stepCount(), first.stepCount());
        EXPECT_EQ(second.report().time, first.report().time);
        EXPECT_EQ(second.report().pieces, first.report().pieces);
        EXPECT_EQ(second.report().volumeRatio, first.report().volumeRatio);
        EXPECT_EQ(second.hands().size(), first.hands().size());
        ASSERT_EQ(second.stateHashes().parts, first.stateHashes().parts);
        for (Simulation* one : {&first, &second}) {
            Work after(seed + 100);
            after.cut(*one);
            after.change(*one);
            after.cut(*one);
        }
        ASSERT_EQ(second.stateHashes().parts, first.stateHashes().parts);
    }
}

/// Leaves memory full of what others wrote.
void soil() {
    for (const std::size_t size : {40, 200, 1'000, 40'000, 4'000'000}) {
        const std::vector<std::vector<unsigned char>> blocks(
            40, std::vector<unsigned char>(size, 0xa5));
        EXPECT_EQ(blocks.back().back(), 0xa5);
    }
}

// Journals, stored ends and tests compare bytes: those between members, of absent values and of
// tables without an order were once whatever had been there before.
TEST_F(StoredMomentTest, EqualStatesHaveEqualBytes) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::vector<std::optional<Bytes>> moments;
        for (int turn = 0; turn < 2; ++turn) {
            Params params = newScene();
            if (seed % 2 == 0) {
                params.floor.reset();
                params.models.resize(1);
            }
            Simulation played(icosphere(2), params);
            Work work(seed);
            work.cut(played);
            work.change(played);
            played.step();
            moments.push_back(bytesOf(played.checkpoint()));
            soil();
            EXPECT_TRUE(bytesOf(played.checkpoint()) == moments.back()) << "of one state";
            soil();
            Simulation other(icosphere(1), Params());
            Work(seed + 100).cut(other);
        }
        ASSERT_TRUE(moments[0]);
        EXPECT_TRUE(moments[0] == moments[1]) << "after other work";
    }
}

TEST_F(StoredMomentTest, APlacedModelComesBackWhereItWas) {
    const auto placed = [] {
        Simulation one = begun();
        Placement turned;
        turned.rotate = {0, 0, 30};
        turned.scale = 1.2;
        EXPECT_EQ(one.execute(Place{turned}), "");
        Work(7).cut(one);
        return one;
    };
    Simulation first = placed();
    Simulation second = begun();
    ASSERT_TRUE(second.goTo(bytesNow(first)));
    EXPECT_EQ(second.placement().scale, 1.2);
    for (Simulation* one : {&first, &second}) {
        Work(8).cut(*one);
    }
    EXPECT_EQ(second.stateHash(), first.stateHash());
}

TEST_F(StoredMomentTest, WhatWasDoneBeforeIsNotUndone) {
    Simulation first = begun();
    Work(3).cut(first);
    Simulation second = begun();
    second.setUndoBudget(std::size_t{1} << 30);
    ASSERT_TRUE(second.goTo(bytesNow(first)));
    EXPECT_FALSE(second.history().canUndo());
    const std::string then = second.stateHash();
    Work(4).cut(second);
    EXPECT_EQ(second.execute(Undo{}), "");
    EXPECT_NE(second.stateHash(), then);  // where the blade came near
    EXPECT_FALSE(second.history().canUndo());
}

TEST_F(StoredMomentTest, NothingIsStoredWhileABladeIsPlaced) {
    Simulation one = begun();
    one.execute(MoveBlade{{{0, 0.8, -1}, {0, 0.8, 1}}});
    EXPECT_FALSE(bytesOf(one.checkpoint()));
    one.step();
    EXPECT_FALSE(bytesOf(one.checkpoint()));
    one.execute(LiftBlade{});
    one.step();
    EXPECT_TRUE(bytesOf(one.checkpoint()));
}

TEST_F(StoredMomentTest, WhatDoesNotFitIsRefused) {
    Simulation first = begun();
    Work(5).cut(first);
    const Bytes bytes = bytesNow(first);
    Simulation other(cubeSphere(5, 0.5), newScene());
    EXPECT_FALSE(other.goTo(bytes));
    Simulation second = begun();
    const std::string atStart = second.stateHash();
    for (const std::size_t size : {std::size_t{0}, bytes.size() / 3, bytes.size() - 1}) {
        EXPECT_FALSE(second.goTo(Bytes(bytes.begin(), bytes.begin() + size))) << size;
        EXPECT_EQ(second.stateHash(), atStart);
    }
    EXPECT_TRUE(second.goTo(bytes));
}

}  // namespace
}  // namespace kerf
