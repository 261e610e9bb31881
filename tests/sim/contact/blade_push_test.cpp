// What the blunt body of the blade does to a soft body (blade_push).
#include "sim/contact/blade_body.h"

namespace kerf {
namespace {

Params pushing() {
    Params params;
    params.bladePush = 1;
    return params;
}

Params blunt() {
    Params params = pushing();
    params.gravity.setZero();
    params.floor.reset();
    return params;
}

Blade acrossZ(double x, double y) {
    return {{x, y, -0.8}, {x, y, 0.8}};
}

Blade upright(double x, double z) {
    return {{x, -0.8, z}, {x, 0.8, z}};
}

/// From where the blade is, or placed there.
void lead(Simulation& simulation, const Blade& from, const Blade& to, int steps) {
    for (int i = simulation.blade() ? 1 : 0; i <= steps; ++i) {
        ASSERT_EQ(simulation.execute(MoveBlade{interpolate(from, to, i / double(steps))}), "");
        simulation.step();
    }
}

/// Coordinates along AB, to the back and across.
Vec3 inBlade(const BladeMotion& blade, const Vec3& p) {
    return blade.frames.back().axes.transpose() * (p - blade.frames.back().origin);
}

/// Where the plate has its whole thickness although it begins behind the front of the cut, which
/// lags behind the edge by up to an edge of the walls; these are as long as the bevel here, or
/// shorter.
double wholeBehind(const BladeMotion& blade) {
    return 2 * blade.bevel;
}

/// Of all living vertices farther than `front` behind the edge [m].
double deepestIn(const BladeMotion& blade, const SurfaceMesh& mesh, double front = 0) {
    double deepest = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) < 0) {
            continue;
        }
        const Vec3 at = inBlade(blade, mesh.position(v));
        if (at.y() > front) {
            deepest = std::max(
                deepest, std::min({blade.frames.back().halfLength - std::fabs(at.x()),
                                   blade.back - at.y(), blade.halfAt(at.y()) - std::fabs(at.z())}));
        }
    }
    return deepest;
}

class BladePushTest : public GlTest {};

TEST_F(BladePushTest, TheBackPushesASphereOverTheFloor) {
    Params params = pushing();
    params.youngsModulus = 1e6;
    params.friction = 0.2;
    Simulation simulation(movedBy(cubeSphere(4), {0, 0.5, 0}), params);
    step(simulation, 20);
    const Vec3 start = middleOf(simulation.mesh());
    lead(simulation, acrossZ(-0.6, 0.45), acrossZ(-0.95, 0.45), 10);
    lead(simulation, acrossZ(-0.95, 0.45), acrossZ(-0.55, 0.45), 160);
    const std::optional<BladeMotion> blade = simulation.bladeBody();
    ASSERT_TRUE(blade.has_value());
    const double backAt = -0.55 + blade->back;
    const Vec3 now = middleOf(simulation.mesh());
    const double touching = -0.5;  // where the back met the sphere
    EXPECT_NEAR(now.x() - start.x(), backAt - touching, 2 * blade->halfThickness);
    EXPECT_NEAR(now.z(), 0, 0.015);
    EXPECT_LT(deepestIn(*blade, simulation.mesh()), 1e-5);
    EXPECT_EQ(simulation.report().pieces, 1);
    EXPECT_EQ(simulation.subdivisions(), SubdivisionCounts{}) << "the back does not cut";
    EXPECT_THAT(simulation.takeMessages(), IsEmpty());
}

TEST_F(BladePushTest, ASlitIsHeldOpenByTheThickness) {
    Params params = blunt();
    params.bladeWidth = 0.3;
    params.bladeThickness = 0.02;
    Simulation simulation(cubeSphere(6), params);
    double fastest = 0;
    const Blade top = acrossZ(0.02, 0.65);
    const Blade inside = acrossZ(0.03, -0.1);
    for (int i = 0; i <= 75; ++i) {
        simulation.execute(MoveBlade{interpolate(top, inside, i / 75.0)});
        simulation.step();
        EXPECT_NE(simulation.lastCut().outcome, CutOutcome::refused);
        fastest = std::max(fastest, topSpeed(simulation.mesh()));
    }
    step(simulation, 20);
    EXPECT_LT(fastest, 4) << "nothing is shot off";
    const BladeMotion blade = *simulation.bladeBody();
    const SurfaceMesh& mesh = simulation.mesh();
    EXPECT_LT(deepestIn(blade, mesh, wholeBehind(blade)), 1e-4);
    int walls = 0;
    double halfWidths = 0;
    for (const int t : livingTriangles(mesh)) {
        const Triangle& corners = mesh.triangle(t);
        if (mesh.kind(t) != SurfaceKind::wall) {
            continue;
        }
        Bounds box;
        for (const int v : corners) {
            box.add(inBlade(blade, mesh.position(v)));
        }
        const Vec3 normal = blade.frames.back().axes.transpose() * areaNormal(cornersOf(mesh, t));
        if (box.low.y() > wholeBehind(blade) && box.high.y() < blade.back) {
            ++walls;
            halfWidths += std::fabs(box.center().z());
            EXPECT_LT(normal.z() * box.center().z(), 0) << "each wall is on its own side";
        }
    }
    ASSERT_GT(walls, 10);
    EXPECT_NEAR(halfWidths / walls, blade.halfThickness, 0.4 * blade.halfThickness);
    EXPECT_EQ(checkClosedManifold(mesh), "");
    EXPECT_THAT(simulation.takeMessages(), IsEmpty());
}

TEST_F(BladePushTest, ABodyThatIsCutThroughPartsAsWithoutIt) {
    Simulation simulation(movedBy(cubeSphere(6), {0, 0.5, 0}), pushing());
    for (int i = 0; i <= 60; ++i) {
        const double y = 1.15 - 1.3 * i / 60;
        simulation.execute(MoveBlade{{{-0.9, y, 0.02}, {0.9, y + 0.02, 0.05}}});
        simulation.step();
        EXPECT_NE(simulation.lastCut().outcome, CutOutcome::refused);
    }
    simulation.execute(LiftBlade{});
    step(simulation, 10);
    EXPECT_EQ(simulation.report().pieces, 2);
    EXPECT_GT(simulation.report().volumeRatio, 0.995);
    EXPECT_EQ(checkClosedManifold(simulation.mesh()), "");
    EXPECT_THAT(simulation.takeMessages(), IsEmpty());
}

// At 6 m/s an implicit step is 15 mm, a step of pbd 30 mm; the blade is 3 mm thick.
TEST_F(BladePushTest, NothingTunnelsThroughItsFlatSide) {
    for (const char* solver : {"implicit", "pbd"}) {
        SCOPED_TRACE(solver);
        Params params = blunt();
        params.bladeWidth = 0.6;
        params.bladeThickness = 0.002;
        setParam(params, "solver", solver);
        Simulation simulation(cubeSphere(5), params);
        lead(simulation, upright(-0.75, -0.5), upright(-0.75, 0.7), 20);
        const Vec3 start = middleOf(simulation.mesh());
        lead(simulation, upright(-0.75, 0.7), upright(0.15, 0.7), 30);
        const BladeMotion blade = *simulation.bladeBody();
        EXPECT_LT(deepestIn(blade, simulation.mesh()),
                  params.solver == SolverMode::implicit ? 1e-3 : 1e-4);
        EXPECT_GT(middleOf(simulation.mesh()).x() - start.x(), 0.3);
        int behind = 0;
        for (const Vec3& p : simulation.mesh().positions()) {
            const Vec3 at = inBlade(blade, p);
            behind += p.x() < 0.15 && at.y() > 0.02 && at.y() < blade.back - 0.02;
        }
        EXPECT_EQ(behind, 0);
        EXPECT_THAT(simulation.takeMessages(), IsEmpty());
    }
}

TEST_F(BladePushTest, SwitchedOnInASlitItOpensItGently) {
    Params params = blunt();
    params.bladePush = 0;
    params.bladeWidth = 0.4;
    Simulation simulation(cubeSphere(5), params);
    lead(simulation, acrossZ(0.02, 0.65), acrossZ(0.02, 0), 40);
    simulation.execute(SetParam{"blade_push", 1.0});
    double fastest = 0;
    for (int i = 0; i < 30; ++i) {
        simulation.step();
        fastest = std::max(fastest, topSpeed(simulation.mesh()));
    }
    const BladeMotion blade = *simulation.bladeBody();
    EXPECT_LT(deepestIn(blade, simulation.mesh(), wholeBehind(blade)), 1e-4);
    EXPECT_LT(fastest, 1.5 * params.depenetrationSpeed);
}

/// Momentum, and angular momentum about the origin.
struct Motion {
    Vec3 momentum = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

Motion motionOf(Simulation& simulation) {
    const BodyModel& model = simulation.bodyModel();
    const SurfaceMesh& mesh = simulation.mesh();
    const PieceModel& piece = model.pieces.front();
    Motion motion;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double area = std::max(model.vertexAreas[v], piece.leastArea);
        const Vec3 part = simulation.params().density * piece.massPerArea * area * mesh.velocity(v);
        motion.momentum += part;
        motion.angular += mesh.position(v).cross(part);
    }
    return motion;
}

/// The middleOf of the plate behind the bevel.
Vec3 middleOfPlate(const BladeMotion& blade) {
    const double y = 0.5 * (blade.front + blade.bevel + blade.back);
    return 0.5 * (blade.frames.front().origin + blade.frames.back().origin) +
           y * blade.frames.back().axes.col(1);
}

void expectGainsWhatTheBladeFeels(Params params, double ofTurn) {
    params.airDrag = 0;
    Simulation simulation(cubeSphere(5), params);
    simulation.feelBlade(true);
    lead(simulation, acrossZ(-0.6, 0.2), acrossZ(-0.95, 0.2), 10);
    Motion given;
    for (int i = 1; i <= 60; ++i) {
        ASSERT_EQ(simulation.execute(MoveBlade{acrossZ(-0.95 + 0.006 * i, 0.2)}), "");
        const BladeLoad load = simulation.step().bladeLoad.value();
        const Vec3 impulse = -params.timeStep * load.force;
        given.momentum += impulse;
        given.angular +=
            middleOfPlate(*simulation.bladeBody()).cross(impulse) - params.timeStep * load.moment;
    }
    EXPECT_EQ(simulation.subdivisions(), SubdivisionCounts{}) << "its back pushes";
    const Motion gained = motionOf(simulation);
    EXPECT_GT(gained.momentum.x(), 10) << "[kg m/s], of half a ton at more than 2 cm/s";
    EXPECT_LT((given.momentum - gained.momentum).norm(), 1e-3 * gained.momentum.norm())
        << given.momentum << "\n\n"
        << gained.momentum;
    EXPECT_LT(gained.angular.z(), -1) << "above its middleOf";
    EXPECT_LT((given.angular - gained.angular).norm(), ofTurn * gained.angular.norm())
        << given.angular << "\n\n"
        << gained.angular;
}

TEST_F(BladePushTest, WhatTheBladeFeelsIsWhatTheBodyGains) {
    expectGainsWhatTheBladeFeels(blunt(), 0.1);
}

TEST_F(BladePushTest, FeelingChangesNoBitAndIsToldOnlyWhereItIsWanted) {
    const auto hashOf = [](bool feels) {
        Simulation simulation(cubeSphere(3), blunt());
        simulation.feelBlade(feels);
        lead(simulation, acrossZ(0.02, 0.8), acrossZ(0.2, 0.1), 15);
        EXPECT_EQ(simulation.report().bladeLoad.has_value(), feels);
        return simulation.stateHash();
    };
    EXPECT_EQ(hashOf(true), hashOf(false));
}

TEST_F(BladePushTest, ABladeInTheAirFeelsNothing) {
    Simulation simulation(cubeSphere(3), blunt());
    simulation.feelBlade(true);
    lead(simulation, acrossZ(0.02, 3), acrossZ(0.2, 2.5), 10);
    EXPECT_TRUE(simulation.report().bladeLoad->force.isZero(0));
    EXPECT_TRUE(simulation.report().bladeLoad->moment.isZero(0));
}

std::string hashAfterAStroke(const Params& params, bool throughAMoment) {
    Simulation simulation(movedBy(cubeSphere(3), {0, 0.45, 0}), params);
    lead(simulation, acrossZ(0.02, 1.1), acrossZ(0.03, 0.5), 15);
    const Checkpoint then = simulation.checkpoint();
    const auto goOn = [&] {
        lead(simulation, acrossZ(0.03, 0.5), acrossZ(0.03, 0.8), 6);
        lead(simulation, acrossZ(0.03, 0.8), acrossZ(0.2, 0.85), 6);
        return simulation.stateHash();
    };
    std::string hash = goOn();
    if (!throughAMoment) {
        return hash;
    }
    simulation.goTo(then);
    return goOn();
}

TEST_F(BladePushTest, ReplaysToTheSameBits) {
    const std::string hash = hashAfterAStroke(pushing(), false);
    EXPECT_EQ(hashAfterAStroke(pushing(), false), hash);
    EXPECT_EQ(hashAfterAStroke(pushing(), true), hash);
    Params off = pushing();
    off.bladePush = 0;
    const std::string cut = hashAfterAStroke(off, false);
    EXPECT_NE(cut, hash);
    off.bladeThickness = 0.1;
    EXPECT_EQ(hashAfterAStroke(off, false), cut) << "what is off has no size";
}

const Vec3 kHalf(0, 0, 0.5);

Blade bladeAt(const Vec3& middle) {
    return {middle - kHalf, middle + kHalf};
}

BladeTrail led(const std::vector<Vec3>& places, double width = 0.2) {
    BladeTrail trail{bladeAt(places.front())};
    for (std::size_t i = 1; i < places.size(); ++i) {
        trail = ledTo(trail, bladeAt(places[i]), width);
    }
    return trail;
}

TEST(BladeTrail, TheBodyTrailsTheEdgeAndComesOutOfWhereItWasPlaced) {
    EXPECT_TRUE(led({{0, 0, 0}}).back.isZero());
    const BladeTrail trail = led({{0, 0, 0}, {0.05, 0, 0}, {0.1, 0, 0.3}});
    EXPECT_LT((trail.back - Vec3(-1, 0, 0)).norm(), 1e-12) << "not along the edge";
    EXPECT_NEAR(trail.widthOf({0.2, 0.01}), 0.1, 1e-12);
    EXPECT_NEAR(led({{0, 0, 0}, {0.5, 0, 0}}).widthOf({0.2, 0.01}), 0.2, 1e-12);
}

TEST(BladeTrail, DrawnBackOrAsideItKeepsItsDirection) {
    for (const Vec3& to : {Vec3(0.1, 0, 0), Vec3(0.4, 0.3, 0), Vec3(0.4, -0.3, 0)}) {
        const BladeTrail trail = led({{0, 0, 0}, {0.4, 0, 0}, to});
        EXPECT_LT((trail.back - Vec3(-1, 0, 0)).norm(), 1e-12);
        EXPECT_NEAR(trail.farthest, 0.4, 1e-12);
        EXPECT_NEAR(trail.way, to.x(), 1e-12);
    }
}

TEST(BladeTrail, AFirstTouchAsideDoesNotTurnItForGood) {
    const BladeTrail trail = led({{0, 0, 0}, {0, 0.001, 0}, {0.1, 0.001, 0}, {0.4, 0.001, 0}});
    EXPECT_LT((trail.back - Vec3(-1, 0, 0)).norm(), 0.01);
    EXPECT_NEAR(trail.farthest, 0.4, 0.002);
}

TEST(BladeTrail, ItFollowsACurve) {
    std::vector<Vec3> places;
    for (int i = 0; i <= 100; ++i) {
        const double angle = 0.01 * i * std::numbers::pi / 2;
        places.emplace_back(std::sin(angle), std::cos(angle), 0);
    }
    const BladeTrail trail = led(places);
    // A point towed at 0.2 on a circle of radius 1 lies on one of radius sqrt(0.96).
    EXPECT_NEAR((places.back() + 0.2 * trail.back).norm(), std::sqrt(0.96), 0.01);
    EXPECT_GT(trail.back.y(), 0.9);
}

TEST(BladeTrail, JitterOfTheHandDoesNotSwingIt) {
    std::vector<Vec3> places{{0, 0, 0}};
    for (int i = 1; i < 60; ++i) {
        places.emplace_back(0.01 * i, i % 2 == 0 ? 0.002 : -0.002, 0);
    }
    EXPECT_LT((led(places).back - Vec3(-1, 0, 0)).norm(), 0.05);
}

TEST(BladeMotion, GoesEvenlyThroughAllPosesOfAStep) {
    std::vector<BladeTrail> trails{led({{-0.5, 0, 0}, {0, 0, 0}})};
    trails.push_back(ledTo(trails.back(), bladeAt({0.1, 0, 0}), 0.2));
    trails.push_back(ledTo(trails.back(), bladeAt({0.4, 0, 0}), 0.2));
    const BladeMotion motion = motionOf(trails, {0.2, 0.01}, 0.03, 0.05, 4);
    ASSERT_EQ(motion.frames.size(), 5U);
    const std::array expected{0.0, 0.05, 0.1, 0.25, 0.4};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(motion.frames[i].origin.x(), expected[i], 1e-12);
        EXPECT_NEAR(motion.frames[i].axes.determinant(), 1, 1e-12);
    }
    EXPECT_EQ(motion.halfAt(0.02), 0);
    EXPECT_NEAR(motion.halfAt(0.06), 0.0025, 1e-12);
    EXPECT_NEAR(motion.halfAt(0.15), 0.005, 1e-12);
    const Bounds box = motion.bounds();
    EXPECT_LT((box.low - Vec3(-0.2, -0.005, -0.5)).norm(), 1e-12);
    EXPECT_LT((box.high - Vec3(0.37, 0.005, 0.5)).norm(), 1e-12);
}

}  // namespace
}  // namespace kerf
