// Bodies that tear where they are pulled apart (tearing).

#include "sim/run/parts/step_report.h"

namespace kerf {
namespace {

// The specimen of Rivlin and Thomas (1953): a strip clamped along its long sides, with a notch from
// a short one. Far ahead of the notch it holds the energy w per volume, behind it none: an advance
// by an area releases w times the height.
const Vec3 kSize{0.12, 0.03, 0.008};        // [m]
const std::array<int, 3> kCells{30, 8, 2};  // squares along each side
constexpr double kNotch = 0.04;             // [m]
constexpr double kModulus = 2e4;            // [Pa]

/// A box around the origin, its sides divided into squares.
SurfaceMesh strip() {
    std::map<std::array<int, 3>, int> numbers;
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    const auto vertex = [&](const std::array<int, 3>& cell) {
        const auto [place, isNew] = numbers.try_emplace(cell, static_cast<int>(points.size()));
        if (isNew) {
            Vec3 share = Vec3::Zero();
            for (int axis = 0; axis < 3; ++axis) {
                share[axis] = static_cast<double>(cell[axis]) / kCells[axis] - 0.5;
            }
            points.push_back(kSize.cwiseProduct(share));
        }
        return place->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (const int side : {0, kCells[axis]}) {
            for (int i = 0; i < kCells[u]; ++i) {
                for (int j = 0; j < kCells[v]; ++j) {
                    const auto at = [&](int di, int dj) {
                        std::array<int, 3> corner{};
                        corner[axis] = side;
                        corner[u] = i + di;
                        corner[v] = j + dj;
                        return vertex(corner);
                    };
                    const std::array<int, 4> c{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
                    for (Triangle t :
                         (i + j) % 2 == 0
                             ? std::array{Triangle{c[0], c[1], c[2]}, Triangle{c[0], c[2], c[3]}}
                             : std::array{Triangle{c[0], c[1], c[3]}, Triangle{c[1], c[2], c[3]}}) {
                        if (side == 0) {
                            std::swap(t[1], t[2]);
                        }
                        triangles.push_back(t);
                    }
                }
            }
        }
    }
    return SurfaceMesh::fromTriangles(points, triangles);
}

Params tearing(double toughness) {
    Params params = weightless();
    params.iterations = 20;
    params.timeStep = 0.002;
    params.youngsModulus = kModulus;
    params.toughness = toughness;
    params.tensileStrength = 1e9;
    params.tearing = 1;
    return params;
}

/// Along z at a place of the middle plane, or nearly so.
Blade at(double x) {
    return {{x, 0.0004, -kSize.z()}, {x, 0.0004, kSize.z()}};
}

class TearTest : public SimulationFixture {
  protected:
    void make(const Params& params, bool notched = true) {
        simulation.emplace(strip(), params);
        if (!notched) {
            return;
        }
        simulation->execute(MoveBlade{at(-0.5 * kSize.x() - 0.01)});
        simulation->step();
        for (int i = 1; i <= 10; ++i) {
            simulation->execute(MoveBlade{at(-0.5 * kSize.x() - 0.01 + (kNotch + 0.01) * i / 10)});
            simulation->step();
        }
        simulation->execute(LiftBlade{});
        simulation->step();
    }
    /// Clamps the long sides, which move apart.
    void pull(double speed) {
        const Vec3 half = 0.5 * kSize;
        const double low = 0.3 * kSize.y() / kCells[1];
        for (const double side : {1.0, -1.0}) {
            const double y = side * half.y();
            simulation->execute(Pin{.region = Bounds{{-1, y - low, -1}, {1, y + low, 1}},
                                    .velocity = Vec3(0, 0.5 * side * speed, 0)});
        }
    }
    /// The energy of new surface in some steps [J].
    double tear(int steps) {
        double energy = 0;
        for (int i = 0; i < steps; ++i) {
            energy += simulation->step().fractureEnergy;
            EXPECT_TRUE(simulation->report().closed);
        }
        return energy;
    }
    /// Along the middle third.
    double strainOfMiddle() {
        const SurfaceMesh& mesh = simulation->mesh();
        const double third = kSize.x() / 6;
        Vec2 sums = Vec2::Zero();
        Vec2 counts = Vec2::Zero();
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const double x = mesh.restPosition(v).x();
            if (std::abs(std::abs(x) - third) < 1e-6) {
                sums[x > 0 ? 1 : 0] += mesh.position(v).x();
                counts[x > 0 ? 1 : 0] += 1;
            }
        }
        const Vec2 means = sums.cwiseQuotient(counts);
        return (means[1] - means[0]) / (2 * third) - 1;
    }
    /// Of what is ahead of the notch [m^2].
    static double ligament() { return (kSize.x() - kNotch) * kSize.z(); }
};

TEST_F(TearTest, NewSurfaceTakesTheToughness) {
    constexpr double kSpeed = 0.004;
    const double toughness = 2;
    make(tearing(1e9), false);
    pull(kSpeed);
    run(200);
    // The strip holds that at this opening, at others with its square.
    const double whole = simulation->report().strainEnergy.value() / std::pow(200 * 0.002, 2);

    Params undamped = tearing(toughness);
    undamped.damping = 0;  // which takes a share of its own
    make(undamped);
    const double cut = tear(5);
    EXPECT_EQ(cut, 0);
    pull(kSpeed);
    double energy = 0;
    int steps = 0;
    while (energy < 0.3 * toughness * ligament() && steps < 1000) {
        energy += tear(1);
        ++steps;
    }
    const double released = whole * std::pow(steps * 0.002, 2) / (kSize.x() * kSize.z());
    EXPECT_NEAR(released / toughness, 1, 0.15);
    energy += tear(300);
    EXPECT_NEAR(energy / (toughness * ligament()), 1, 0.1);
    EXPECT_EQ(simulation->report().pieces, 2);
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 1e-3);
    EXPECT_THAT(simulation->takeMessages(), IsEmpty());
}

TEST_F(TearTest, NothingTearsThatIsToughEnoughOrNotToTear) {
    for (const bool on : {true, false}) {
        Params params = tearing(on ? 1e4 : 0.01);
        params.tearing = on ? 1 : 0;
        make(params);
        const int triangles = simulation->report().triangles;
        pull(0.02);
        EXPECT_EQ(tear(100), 0);
        EXPECT_EQ(simulation->report().triangles, triangles);
    }
}

TEST_F(TearTest, ALowerStrengthTearsNoLess) {
    for (const double strength : {1e9, 0.02 * kModulus, 1.0}) {
        Params params = tearing(1);
        params.tensileStrength = strength;
        make(params);
        pull(0.04);
        tear(200);
        EXPECT_GE(simulation->report().pieces, 2) << strength;
    }
}

TEST_F(TearTest, BondsPartWhenNothingIsToTearOn) {
    make(tearing(0.5));
    pull(0.04);
    while (!simulation->report().tear || !simulation->report().tear->advanced) {
        ASSERT_LT(simulation->stepCount(), 200);
        simulation->step();
    }
    run(10);
    simulation->execute(SetParam{"tearing", 0.0});
    EXPECT_GT(tear(50), 0);
    EXPECT_FALSE(simulation->report().tear.has_value());
    EXPECT_EQ(simulation->report().pieces, 1);
}

TEST_F(TearTest, ContinuesBitForBitFromAMoment) {
    make(tearing(1));
    pull(0.04);
    while (!simulation->report().tear || !simulation->report().tear->advanced) {
        ASSERT_LT(simulation->stepCount(), 200);
        simulation->step();
    }
    run(5);
    const Checkpoint then = simulation->checkpoint();
    run(15);
    const std::string hash = simulation->stateHash();
    simulation->goTo(then);
    run(15);
    EXPECT_EQ(simulation->stateHash(), hash);
}

TEST_F(TearTest, UndoOfAPullTakesTheTearBack) {
    make(tearing(0.5));
    simulation->setUndoBudget(1 << 30);
    const int triangles = simulation->report().triangles;
    const Vec3 corner(-0.5 * kSize.x(), 0.3 * kSize.y(), 0);
    simulation->execute(Pin{.region = Bounds{{-1, -1, -1}, {1, -0.4 * kSize.y(), 1}}});
    simulation->execute(Grab{.at = corner, .radius = 0.01});
    for (int i = 0; i < 150; ++i) {
        simulation->execute(Drag{0, corner + Vec3(0, 2e-4 * i, 0)});
        simulation->step();
    }
    EXPECT_GT(simulation->report().triangles, triangles);
    simulation->execute(Release{});
    simulation->step();
    EXPECT_EQ(simulation->execute(Undo{}), "");
    simulation->step();
    EXPECT_EQ(simulation->report().triangles, triangles);
}

TEST_F(TearTest, AnUncutPlaceBeginsToTearAtTheStrength) {
    Params params = tearing(0.5);
    params.tensileStrength = 0.2 * kModulus;
    make(params, false);
    constexpr double kSpeed = 0.06;
    const Vec3 half = 0.5 * kSize;
    for (const double side : {1.0, -1.0}) {
        const double x = side * half.x();
        simulation->execute(Pin{.region = Bounds{{x - 0.002, -1, -1}, {x + 0.002, 1, 1}},
                                .velocity = Vec3(0.5 * kSpeed * side, 0, 0)});
    }
    double strain = 0;
    while (tear(1) == 0 && simulation->stepCount() < 500) {
        strain = strainOfMiddle();
    }
    EXPECT_NEAR(strain, 0.2, 0.04);
    tear(100);
    EXPECT_GE(simulation->report().pieces, 2);
}

// The lower half hangs by what is ahead of the notch.
TEST_F(TearTest, WeightTears) {
    for (const double toughness : {0.5, 500.0}) {
        make(tearing(toughness));
        simulation->execute(Pin{.region = Bounds{{-1, 0.4 * kSize.y(), -1}, {1, 1, 1}}});
        simulation->execute(SetParam{"gravity", Vec3(0, -100, 0)});
        tear(150);
        EXPECT_EQ(simulation->report().pieces, toughness < 1 ? 2 : 1);
    }
}

TEST_F(TearTest, AFallOnTheEdgeOfABoxTears) {
    for (const double strength : {0.1, 10.0}) {
        Params params = tearing(0.5);
        params.tensileStrength = strength * kModulus;
        make(params, false);
        simulation->execute(
            AddBox{{.center = Vec3(0, -0.5 * kSize.y() - 0.06, 0), .size = Vec3(0.01, 0.1, 0.1)}});
        simulation->execute(SetParam{"gravity", Vec3(0, -50, 0)});
        EXPECT_EQ(tear(150) > 0, strength < 1);
    }
}

// Its plate wedges the walls of the notch apart, far behind the end.
TEST_F(TearTest, ABladeThatPushesTears) {
    for (const double toughness : {0.5, 500.0}) {
        Params params = tearing(toughness);
        params.bladePush = 1;
        params.bladeThickness = 0.05;
        make(params);
        simulation->execute(SetParam{"blade_feels", 1.0});
        simulation->execute(Pin{.region = Bounds{{0.45 * kSize.x(), -1, -1}, {1, 1, 1}}});
        double energy = 0;
        for (int i = 0; i <= 50; ++i) {
            const double way = -0.01 + (0.8 * kNotch + 0.01) * i / 50;
            simulation->execute(MoveBlade{at(-0.5 * kSize.x() + way)});
            energy += tear(1);
        }
        EXPECT_EQ(energy > 0.02 * toughness * ligament(), toughness < 1) << energy;
    }
}

TEST_F(TearTest, ABladeInTheAirKeepsItsStroke) {
    std::vector<std::size_t> strokes;
    for (const int on : {0, 1}) {
        Params params = tearing(1e4);
        params.tearing = on;
        make(params, false);
        // Down through the strip, past its end, and up through it elsewhere.
        const std::array<Vec2, 5> path{
            Vec2(0.02, 0.02), {0.02, -0.02}, {0.07, -0.02}, {-0.02, -0.02}, {-0.02, 0.02}};
        for (std::size_t leg = 0; leg + 1 < path.size(); ++leg) {
            for (int i = 0; i <= 8; ++i) {
                const Vec2 p = path[leg] + (path[leg + 1] - path[leg]) * i / 8;
                simulation->execute(
                    MoveBlade{{{p.x(), p.y(), -kSize.z()}, {p.x(), p.y(), kSize.z()}}});
                simulation->step();
            }
        }
        simulation->execute(LiftBlade{});
        simulation->step();
        strokes.push_back(simulation->strokes().size());
    }
    EXPECT_EQ(strokes[1], strokes[0]) << "with and without tearing";
}

TEST_F(TearTest, SaysOnceWhyNothingTears) {
    make(tearing(1), false);
    run(3);
    EXPECT_THAT(simulation->takeMessages(), IsEmpty());
    simulation->execute(SetParam{"toughness", 0.0});
    run(3);
    simulation->execute(SetParam{"toughness", 1.0});
    run(3);
    EXPECT_THAT(simulation->takeMessages(),
                ElementsAre(HasSubstr("step 3: Nothing tears with a toughness")));
}

TEST_F(TearTest, ABladeTakesOver) {
    Params params = tearing(1);
    params.debrisVolume = 0;  // nothing to tell of the end of the stroke
    make(params);
    pull(0.02);
    run(65);
    EXPECT_TRUE(simulation->report().tear.has_value());
    simulation->execute(MoveBlade{at(0.5 * kSize.x() + 0.01)});
    simulation->step();
    for (int i = 1; i <= 20; ++i) {
        simulation->execute(MoveBlade{at(0.5 * kSize.x() + 0.01 - 0.002 * i)});
        simulation->step();
        EXPECT_TRUE(simulation->report().closed);
    }
    simulation->execute(LiftBlade{});
    tear(100);
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    EXPECT_THAT(simulation->takeMessages(), IsEmpty());
}

}  // namespace
}  // namespace kerf
