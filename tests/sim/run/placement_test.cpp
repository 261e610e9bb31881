// A model that is placed otherwise while it is simulated.
#include "sim/base/size_params.h"

namespace kerf {
namespace {

constexpr std::size_t kBudget = 1u << 30;

class PlacementTest : public SimulationFixture {
  protected:
    void SetUp() override {
        SimulationFixture::SetUp();
        simulation.emplace(cubeSphere(6, 0.5), weightless());
        simulation->setUndoBudget(kBudget);
        inches.unit = LengthUnit::inch;
        inches.up = UpAxis::x;
    }
    /// Right through the middle of a sphere that is so many times as large.
    void cut(double size) {
        const auto bladeAt = [&](double y) {
            return Blade{size * Vec3(-1, y, 0.01), size * Vec3(1, y, 0.02)};
        };
        makeStroke(*simulation, bladeAt(1), bladeAt(-1), 20);
    }
    std::string place(const Placement& placement, bool continues = false) {
        return simulation->execute(Place{placement, continues});
    }

    Placement inches;
};

TEST_F(PlacementTest, IsThatOfASimulationThatBeganSo) {
    cut(1);
    EXPECT_EQ(place(inches), "");
    EXPECT_EQ(simulation->report().pieces, 1);
    cut(0.0254);
    EXPECT_EQ(simulation->report().pieces, 2);
    const std::string hash = simulation->stateHash();

    SurfaceMesh small = cubeSphere(6, 0.5);
    const PlacementMap map(inches);
    for (int v = 0; v < small.vertexCount(); ++v) {
        const Vec3 at = map.toScene(small.restPosition(v));
        small.setPosition(v, at);
        small.setRestPosition(v, at);
    }
    const Params params = simulation->params();
    simulation.emplace(std::move(small), params);
    cut(0.0254);
    EXPECT_EQ(simulation->stateHash(), hash);
}

TEST_F(PlacementTest, UndoBringsTheCutBodyBackAndRedoThePlacement) {
    cut(1);
    const std::string before = simulation->stateHash();
    const Params params = simulation->params();
    place(inches);
    EXPECT_NE(simulation->params(), params);
    const std::string after = simulation->stateHash();
    EXPECT_EQ(simulation->history().lastDone().name, "Placement");
    EXPECT_EQ(simulation->execute(Undo{}), "");
    EXPECT_EQ(simulation->stateHash(), before);
    EXPECT_EQ(simulation->params(), params);
    EXPECT_EQ(simulation->placement(), Placement{});
    run(3);  // with the parts of a body of the old size
    EXPECT_EQ(simulation->report().lostPieces, 0);
    EXPECT_EQ(simulation->execute(Redo{}), "");
    EXPECT_EQ(simulation->stateHash(), after);
    EXPECT_EQ(simulation->placement(), inches);
}

TEST_F(PlacementTest, AGestureIsOneChangeAndItsWayDoesNotMatter) {
    const std::string before = simulation->stateHash();
    for (const double scale : {1.1, 1.7, 3.0}) {
        Placement larger;
        larger.scale = scale;
        place(larger, scale > 1.2);
    }
    EXPECT_EQ(simulation->history().done(), 1U);
    const std::string hash = simulation->stateHash();
    simulation->execute(Undo{});
    EXPECT_EQ(simulation->stateHash(), before);
    Placement atOnce;
    atOnce.scale = 3;
    place(atOnce);
    EXPECT_EQ(simulation->stateHash(), hash);
    place(Placement{});
    EXPECT_EQ(simulation->stateHash(), before);
}

TEST_F(PlacementTest, PreparedElsewhereItIsTheSameAndAnotherOneDoesWithout) {
    const auto preparedAt = [this](const Placement& placement) {
        const std::vector<PlacedModel> models{{placement, 0}};
        return makeUncutBody(placedMesh(*simulation->firstUncut(), models), models);
    };
    cut(1);
    const std::string cutBody = simulation->stateHash();
    EXPECT_EQ(place(inches), "");
    const std::string placed = simulation->stateHash();
    simulation->execute(Undo{});
    EXPECT_EQ(simulation->stateHash(), cutBody);

    const auto prepared = preparedAt(inches);
    simulation->expectPlacement(prepared);
    EXPECT_EQ(place(inches), "");
    EXPECT_EQ(simulation->uncut(), prepared);
    EXPECT_EQ(simulation->stateHash(), placed);
    cut(0.0254);
    EXPECT_EQ(simulation->report().pieces, 2);
    const std::string cutAgain = simulation->stateHash();
    simulation->execute(Undo{});
    EXPECT_EQ(simulation->report().pieces, 1);
    simulation->execute(Undo{});
    EXPECT_EQ(simulation->stateHash(), cutBody) << "back in the mesh of the first placement";
    simulation->execute(Redo{});
    simulation->execute(Redo{});
    EXPECT_EQ(simulation->stateHash(), cutAgain);

    simulation->execute(Undo{});
    simulation->expectPlacement(preparedAt(Placement{}));
    Placement elsewhere = inches;
    elsewhere.scale = 2;
    EXPECT_EQ(place(elsewhere), "");
    EXPECT_EQ(simulation->placement(), elsewhere);
}

TEST_F(PlacementTest, OneWithoutRoomInFloatsIsRefusedAndChangesNothing) {
    const std::string before = simulation->stateHash();
    Placement far;
    far.translate.x() = 1e6;
    const std::string problem = place(far);
    EXPECT_EQ(problem.find("The model would be 1 m long and reach"), 0U) << problem;
    EXPECT_EQ(simulation->stateHash(), before);
    EXPECT_EQ(simulation->history().done(), 0U);
}

TEST_F(PlacementTest, MomentsAndResetsKnowTheirOwn) {
    const Checkpoint first = simulation->checkpoint();
    const std::string before = simulation->stateHash();
    place(inches);
    const Checkpoint second = simulation->checkpoint();
    const std::string after = simulation->stateHash();
    simulation->goTo(first);
    EXPECT_EQ(simulation->stateHash(), before);
    simulation->goTo(second);
    EXPECT_EQ(simulation->stateHash(), after);
    simulation->execute(Restart{});
    EXPECT_EQ(simulation->stateHash(), after);
    simulation->reset();
    EXPECT_EQ(simulation->stateHash(), before);
}

TEST_F(PlacementTest, WhatIsTinyOrHugeIsCutInTwoAsItFalls) {
    for (const double size : {0.001, 0.01, 300.0}) {
        const Params params = suitedTo(size * std::sqrt(3.0), Params{});
        simulation.emplace(cubeSphere(6, 0.5 * size), params);
        Placement raised;
        raised.translate.y() = 0.52 * size;
        place(raised);
        cut(1.2 * size);
        run(40);
        EXPECT_EQ(simulation->report().pieces, 2) << size;
        EXPECT_EQ(simulation->report().lostPieces, 0) << size;
        const Bounds& bounds = simulation->bounds();
        EXPECT_LT(bounds.diagonal(), 4 * size) << size;
        EXPECT_GT(bounds.low.y(), -0.05 * size) << size;
    }
}

// The same scene at another size. What a solver bounds by a length or a speed of its own would
// leave large bodies behind, or let small ones loose. Powers of four, to compare all bits: roots of
// stiffness, which grows with the cube, are exact then.

constexpr double kBallRadius = 0.5;  // of the ball [m]
constexpr int kPartSteps = 30;       // of each part of a scene

/// Of a body that is `size` times as large, and in which all speeds are: as fast are its waves.
Params paramsOfSize(double size) {
    Params params = weightless();
    params.contact = 0;  // whose sums have the same unit at any size
    params.youngsModulus = 2e5 * size * size;
    params.toughness = 200 * size * size * size;
    params.tensileStrength = 2e4 * size * size;
    return params;
}

class SizeTest : public SimulationFixture {
  protected:
    void make(double size, int tearing) {
        size_ = size;
        opening_ = 0;
        Params params = paramsOfSize(size);
        params.tearing = tearing;
        simulation.emplace(cubeSphere(6, size * kBallRadius), params);
        for (const int hand : {0, 1}) {
            EXPECT_EQ(simulation->execute(Grab{hand, handAt(hand), 0.2 * size}), "");
        }
    }
    /// The hands go on apart.
    void draw() {
        for (int i = 0; i < kPartSteps; ++i) {
            step();
        }
    }
    void cut() {
        for (int i = 0; i <= kPartSteps; ++i) {
            const double y = size_ * (0.6 - 0.6 * i / kPartSteps);
            const Vec3 half(0, 0, 0.6 * size_);
            const Vec3 at(0.03 * size_, y, 0);
            simulation->execute(MoveBlade{{at - half, at + half}});
            step();
        }
        simulation->execute(LiftBlade{});
    }
    void letGo() {
        simulation->execute(Release{0});
        simulation->execute(Release{1});
        run(kPartSteps);
    }
    /// By vertex, in sizes.
    std::vector<Vec3> places() {
        std::vector<Vec3> places;
        places.reserve(simulation->mesh().vertexCount());
        for (int v = 0; v < simulation->mesh().vertexCount(); ++v) {
            places.emplace_back(simulation->mesh().position(v) / size_);
        }
        return places;
    }

  private:
    Vec3 handAt(int hand) const {
        return {(hand == 0 ? -1 : 1) * (kBallRadius * size_ + opening_), 0, 0};
    }
    void step() {
        opening_ += 0.01 * size_;
        for (const int hand : {0, 1}) {
            simulation->execute(Drag{hand, handAt(hand)});
        }
        simulation->step();
    }

    double size_ = 1;
    double opening_ = 0;
};

TEST_F(SizeTest, CutsOfADrawnBodyOpenAlike) {
    std::vector<std::vector<Vec3>> ends;
    for (const double size : {1.0, 4.0, 64.0}) {
        make(size, 0);
        draw();
        cut();
        draw();
        letGo();
        ends.push_back(places());
    }
    EXPECT_EQ(ends[1], ends[0]);
    EXPECT_EQ(ends[2], ends[0]);
}

TEST_F(SizeTest, BodiesTearAlike) {
    std::vector<std::vector<Vec3>> ends;
    for (const double size : {1.0, 4.0, 64.0}) {
        make(size, 1);
        const int whole = simulation->report().triangles;
        draw();
        draw();
        EXPECT_GT(simulation->report().triangles, whole);
        letGo();
        ends.push_back(places());
    }
    EXPECT_EQ(ends[1], ends[0]);
    EXPECT_EQ(ends[2], ends[0]);
}

}  // namespace
}  // namespace kerf
