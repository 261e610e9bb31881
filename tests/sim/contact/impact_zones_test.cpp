// Bodies thinner than their triangles are long: a step leads no triangles through each other.

#include "sim/contact/impact_zones.h"

namespace kerf {
namespace {

/// A bar with fins on it, about a metre long, extruded along z from few long triangles: 156 of
/// them, in walls of 2 cm.
SurfaceMesh finned() {
    constexpr int kFins = 9;
    std::vector<Vec3> profile = {{0, 0, 0}, {10, 0, 0}, {10, 0.3, 0}};
    std::vector<Triangle> triangles;
    std::vector<int> top = {1, 2};
    for (int i = 0; i < kFins; ++i) {
        const int first = static_cast<int>(profile.size());
        for (const auto& [x, y] : {std::pair(9.5, 0.3), {9.5, 2.5}, {9.3, 2.5}, {9.3, 0.3}}) {
            profile.emplace_back(x - i, y, 0);
        }
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 3});
        top.insert(top.end(), {first, first + 3});
    }
    const int corners = static_cast<int>(profile.size()) + 1;
    profile.emplace_back(0, 0.3, 0);
    top.push_back(corners - 1);
    for (std::size_t i = 0; i + 1 < top.size(); ++i) {
        triangles.push_back({0, top[i], top[i + 1]});
    }
    TriangleSoup soup;
    for (const double z : {2.5, -2.5}) {
        for (const Vec3& p : profile) {
            soup.positions.emplace_back((p + Vec3(-5, -1.25, z)) / 11.5);
        }
    }
    for (const Triangle& t : triangles) {
        soup.triangles.push_back(t);
        soup.triangles.push_back({t[2] + corners, t[1] + corners, t[0] + corners});
    }
    for (int a = 0; a < corners; ++a) {
        const int b = (a + 1) % corners;
        soup.triangles.push_back({a + corners, b + corners, b});
        soup.triangles.push_back({a + corners, b, a});
    }
    return meshOf(soup);
}

/// A plate whose upper side a step led through the lower one, at one end.
struct CrossedPlate {
    SurfaceMesh mesh = box({1, 0.02, 1}, 2);
    BodyModel model = buildBodyModel(mesh);
    std::vector<Vec3> before = mesh.positions();

    CrossedPlate() {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.position(v).y() > 0 && mesh.position(v).x() > -0.1) {
                mesh.setState(v, before[v] - Vec3(0, 0.05, 0), {0.3, -10, 0});
            }
        }
    }

    Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            sum += unitMass(model, v) * mesh.velocity(v);
        }
        return sum;
    }
};

TEST(ImpactZones, TellThinBodies) {
    EXPECT_TRUE(thinWalls(buildBodyModel(finned())).many());
    const ThinWalls plate = thinWalls(buildBodyModel(box({1, 0.02, 1}, 4)));
    EXPECT_TRUE(plate.many());
    EXPECT_NEAR(plate.thickness, 0.02, 0.01) << "slanted at the rim";
    EXPECT_NEAR(plate.edge, std::hypot(0.25, 0.25), 1e-6);
    EXPECT_FALSE(thinWalls(buildBodyModel(box({1, 0.5, 1}, 4))).many());
    for (const char* name : {"sphere20", "sphere80", "sphere768", "octopus", "banana"}) {
        EXPECT_FALSE(thinWalls(buildBodyModel(builtin(name))).many()) << name;
    }
}

TEST(ImpactZones, TakeBackWhatWouldPassThrough) {
    CrossedPlate plate;
    const Vec3 momentum = plate.momentum();
    ASSERT_GT(selfIntersections(plate.mesh).size(), 0U);
    EXPECT_TRUE(stopCrossings({plate.model, plate.before, std::nullopt}, plate.mesh));
    EXPECT_EQ(selfIntersections(plate.mesh).size(), 0U);
    EXPECT_LT((plate.momentum() - momentum).norm(), 1e-5 * momentum.norm());
}

TEST(ImpactZones, LeaveOthersAlone) {
    CrossedPlate plate;
    std::vector<Vec3> crossed = plate.mesh.positions();
    const SurfaceMesh mesh = plate.mesh;
    EXPECT_FALSE(stopCrossings({plate.model, crossed, std::nullopt}, plate.mesh));
    EXPECT_EQ(plate.mesh.positions(), mesh.positions());
}

TEST(ImpactZones, KeepPinsAndFloor) {
    CrossedPlate plate;
    std::vector<std::uint32_t> pinned(plate.mesh.vertexCount());
    std::iota(pinned.begin(), pinned.end(), 0);
    std::erase_if(pinned, [&](std::uint32_t v) { return plate.before[v].x() > -0.4; });
    EXPECT_TRUE(stopCrossings({plate.model, plate.before, -0.012, pinned}, plate.mesh));
    for (const std::uint32_t v : pinned) {
        EXPECT_EQ(plate.mesh.position(static_cast<int>(v)), plate.before[v]);
    }
    for (const Vec3& p : plate.mesh.positions()) {
        EXPECT_GE(p.y(), -0.012 - 1e-7);
    }
}

class FallingThinBody : public GlTest {};

// It ended with 374 pairs.
TEST_F(FallingThinBody, DoesNotPassThroughItself) {
    Params params;
    params.floor = -1.25 / 11.5 - 0.15;
    Simulation simulation(finned(), params);
    step(simulation, 130);
    EXPECT_LE(selfIntersections(simulation.mesh()).size(), 4U);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 0.05);
    EXPECT_LT(simulation.report().kineticEnergy, 0.1 * simulation.report().potentialEnergy);
}

// Nothing is remembered from step to step but where the body is.
TEST_F(FallingThinBody, GoesOnFromAMoment) {
    Params params;
    params.floor = -1.25 / 11.5 - 0.05;
    Simulation simulation(finned(), params);
    const auto run = [&](int steps) {
        step(simulation, steps);
        return simulation.stateHash();
    };
    run(30);
    const Checkpoint then = simulation.checkpoint();
    const std::string hash = run(20);
    simulation.goTo(then);
    EXPECT_EQ(run(20), hash);
}

}  // namespace
}  // namespace kerf
