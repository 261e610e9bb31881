// The same scene at another size. What a solver bounds by a length or a speed of its own would
// leave large bodies behind, or let small ones loose. Powers of four, to compare all bits: roots of
// stiffness, which grows with the cube, are exact then.
#include <gtest/gtest.h>

#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

constexpr double kBallRadius = 0.5;  // of the ball [m]
constexpr int kPartSteps = 30;       // of each part of a scene

/// Of a body that is `size` times as large, and in which all speeds are: as fast are its waves.
Params paramsOfSize(double size) {
    Params params = test::weightless();
    params.contact = 0;  // whose sums have the same unit at any size
    params.youngsModulus = 2e5 * size * size;
    params.toughness = 200 * size * size * size;
    params.tensileStrength = 2e4 * size * size;
    return params;
}

class SizeTest : public test::SimulationTest {
  protected:
    void make(double size, int tearing) {
        size_ = size;
        opening_ = 0;
        Params params = paramsOfSize(size);
        params.tearing = tearing;
        simulation.emplace(test::cubeSphere(6, size * kBallRadius), params);
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
