#include "sim/contact/obstacles.h"
#include "tests/support/bar_falls.h"

namespace kerf {
namespace {

Params withoutFloor() {
    Params params;
    params.floor.reset();
    return params;
}

SurfaceMesh lifted(SurfaceMesh mesh, double by, const Vec3& velocity = Vec3::Zero()) {
    mesh = movedBy(std::move(mesh), {0, by, 0});
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setVelocity(v, velocity);
    }
    return mesh;
}

/// How deep the deepest vertex lies inside a box [m].
double deepestVertexIn(const StaticBox& box, const SurfaceMesh& mesh) {
    double deepest = 0;
    for (const Vec3& p : mesh.positions()) {
        const Vec3 at = box.axes().transpose() * (p - box.center);
        deepest = std::max(deepest, (0.5 * box.size - at.cwiseAbs()).minCoeff());
    }
    return deepest;
}

/// How deep the surface of a box lies inside a mesh, at 5 x 5 x 5 points of its edges and faces
/// [m].
double deepestPointOf(const StaticBox& box, const SurfaceMesh& mesh) {
    double deepest = 0;
    for (int i = 0; i < 125; ++i) {
        const Vec3 at(i % 5, (i / 5) % 5, i / 25.0 - std::fmod(i / 25.0, 1));
        if ((at.array() - 2).abs().maxCoeff() < 2) {
            continue;
        }
        const Vec3 p =
            box.center + box.axes() * ((at.array() / 4 - 0.5) * box.size.array()).matrix();
        deepest = std::max(deepest, depthInside(mesh, p));
    }
    return deepest;
}

class BoxContactTest : public GlTest {};

TEST_F(BoxContactTest, ABodyRestsOnABoxAsOnTheFloor) {
    Params params = Params{};
    const StaticBox slab{{0, -0.5, 0}, {4, 1, 4}, {0, 90, 0}};
    params.contactThickness = 0;
    Simulation onFloor(lifted(cubeSphere(5), 0.55), params);
    params.floor.reset();
    Simulation onBox(lifted(cubeSphere(5), 0.55), params, {slab});
    for (int i = 0; i < 70; ++i) {
        onFloor.step();
        onBox.step();
    }
    // Contacts of implicit steps yield to what weighs on them.
    EXPECT_LT(deepestVertexIn(slab, onBox.mesh()), 3e-4);
    EXPECT_LT((middleOf(onFloor.mesh()) - middleOf(onBox.mesh())).norm(), 2e-3);
    EXPECT_GT(onBox.report().volumeRatio, 0.99);
}

// As after a fall of two metres; an implicit step is 10 mm, a step of pbd 31 mm.
TEST_F(BoxContactTest, NothingTunnelsThroughAThinPlate) {
    const StaticBox plate{{0, 0, 0}, {3, 0.002, 3}, {0, 20, 12}};
    for (const char* solver : {"implicit", "pbd"}) {
        for (const SurfaceMesh& shape : {cubeSphere(4), test::box({0.8, 0.5, 0.6}, 1)}) {
            SCOPED_TRACE(solver + std::to_string(shape.vertexCount()));
            Params params = withoutFloor();
            setParam(params, "solver", solver);
            Simulation simulation(lifted(shape, 0.8, {0, -6.3, 0}), params, {plate});
            step(simulation, 40);
            const Vec3 up = plate.axes().col(1);
            double lowest = 1;
            for (const Vec3& p : simulation.mesh().positions()) {
                lowest = std::min(lowest, up.dot(p));
            }
            EXPECT_GT(lowest, 0.0005);
            EXPECT_THAT(simulation.takeMessages(), IsEmpty());
        }
    }
}

// The faces of the block are a metre long, the boxes a tenth: no vertex gets near them.
TEST_F(BoxContactTest, ACoarseBodyDoesNotSinkOntoSmallBoxes) {
    const Vec3 size = Vec3::Constant(0.1);
    for (const StaticBox& box : {StaticBox{{0.2, 0, 0.1}, size, {0, 30, 0}},         // a face
                                 StaticBox{{0.2, 0, 0.1}, size, {45, 10, 0}},        // an edge
                                 StaticBox{{0.2, 0, 0.1}, size, {45, 0, 35.26}}}) {  // a corner
        SCOPED_TRACE(box.rotate.x() + box.rotate.z());
        Params params;
        params.floor = -0.3;
        params.gravity = {0, -2, 0};
        Simulation simulation(lifted(test::box({1, 0.6, 1}, 1), 0.42, {0, -3, 0}), params, {box});
        double deepest = 0;
        for (int i = 0; i < 60; ++i) {
            simulation.step();
            deepest = std::max(deepest, deepestPointOf(box, simulation.mesh()));
        }
        EXPECT_LT(deepest, 0.002);
        EXPECT_GT(middleOf(simulation.mesh()).y(), 0.1) << "it lies on the box and the floor";
        EXPECT_THAT(simulation.takeMessages(), IsEmpty());
    }
}

// A bar far thinner than an edge of the body, around which the skin bends sharply in the rebound.
TEST_F(BoxContactTest, NothingIsPiercedByAThinBar) {
    for (const double width : {0.01, 0.02}) {
        SCOPED_TRACE(width);
        BarFall fall;
        fall.width = width;
        fall.modulus = 1e5;
        fall.height = 2;
        fall.aside = 0.001;
        fall.seconds = 0.45;
        const BarFigures figures = fallOnBar(fall, Params{});
        EXPECT_EQ(figures.pierced, 0) << text(figures);
        EXPECT_GT(figures.leastVolume, 0.995);
    }
}

/// How far a block slides down a slope of 20 degrees in a third of a second [m].
double slideDown(double friction) {
    const double tilt = 20;
    Params params = withoutFloor();
    params.friction = friction;
    params.airDrag = 0;
    params.contactThickness = 0;
    params.youngsModulus = 1e6;
    StaticBox slope{{0, 0, 0}, {6, 0.4, 4}, {0, 0, -tilt}};
    SurfaceMesh block = test::box({0.6, 0.2, 0.6}, 4);
    for (int v = 0; v < block.vertexCount(); ++v) {
        block.setPosition(v, slope.axes() * (block.position(v) + Vec3(0, 0.3, 0)));
        block.setRestPosition(v, block.position(v));
    }
    Simulation simulation(block, params, {slope});
    const Vec3 start = middleOf(simulation.mesh());
    step(simulation, 80);
    return slope.axes().col(0).dot(middleOf(simulation.mesh()) - start);
}

TEST_F(BoxContactTest, FrictionHoldsOnASlopeOrSlowsDown) {
    EXPECT_LT(slideDown(0.6), 0.02);
    const double angle = 20.0 * double(EIGEN_PI) / 180;
    for (const double friction : {0.0, 0.15}) {
        const double rate = 9.81 * (std::sin(angle) - friction * std::cos(angle));
        const double way = 0.5 * rate * 0.4 * 0.4;
        EXPECT_NEAR(slideDown(friction), way, 0.05 * way) << friction;
    }
}

TEST_F(BoxContactTest, ABoxInTheBodyPushesItOutGently) {
    const StaticBox box{{0, -0.45, 0}, {3, 0.4, 3}};
    Params params = withoutFloor();
    params.gravity.setZero();
    Simulation simulation(cubeSphere(5), params);
    simulation.step();
    ASSERT_EQ(simulation.execute(AddBox{box}), "");
    double fastest = 0;
    for (int i = 0; i < 100; ++i) {
        simulation.step();
        fastest = std::max(fastest, topSpeed(simulation.mesh()));
    }
    EXPECT_LT(deepestVertexIn(box, simulation.mesh()), 1e-6);
    EXPECT_LT(fastest, 3);
}

/// RMS distance from the rest shape, laid over it [m].
double shapeErrorOf(const SurfaceMesh& mesh) {
    std::vector<int> all(mesh.vertexCount());
    std::iota(all.begin(), all.end(), 0);
    return rmsShapeError(mesh.restPositions(), mesh.positions(), all);
}

/// A sphere of 1 m in a box of 1.4 m that it is a little off the middle of.
struct Enclosed {
    const char* name;
    Vec3 turn, offset;  // of the box [degrees], of the sphere in its axes [m]
    int axis;           // of the box, along which the sphere has the least way out
    std::optional<double> floor;
};

TEST_F(BoxContactTest, ABodyInABoxLeavesItWholeThroughOneFace) {
    for (const Enclosed& c : {Enclosed{"right", {0, 0, 0}, {0.1, 0.03, 0.02}, 0, {}},
                              Enclosed{"turned", {20, 30, 0}, {0.01, -0.03, -0.1}, 2, {}},
                              Enclosed{"floor", {0, 0, 0}, {0.02, -0.1, 0.05}, 2, -0.9}}) {
        SCOPED_TRACE(c.name);
        StaticBox box{{0, 0, 0}, Vec3::Constant(1.4), c.turn};
        box.center = -box.axes() * c.offset;
        Params params = withoutFloor();
        params.floor = c.floor;
        params.gravity.setZero();
        Simulation simulation(cubeSphere(5), params, {box});
        for (int i = 0; i < 300; ++i) {
            simulation.step();
            ASSERT_NEAR(simulation.report().volumeRatio, 1, 1e-3) << i;
        }
        const Vec3 at = box.axes().transpose() * (middleOf(simulation.mesh()) - box.center);
        const double side = c.offset[c.axis] < 0 ? -1 : 1;
        EXPECT_GT(side * at[c.axis], 0.7 + 0.45);
        Vec3 beside = at - c.offset;
        beside[c.axis] = 0;
        EXPECT_LT(beside.norm(), 0.02);
        EXPECT_EQ(deepestVertexIn(box, simulation.mesh()), 0);
        EXPECT_LT(shapeErrorOf(simulation.mesh()), 0.006);
        EXPECT_THAT(simulation.takeMessages(), IsEmpty());
    }
}

TEST_F(BoxContactTest, ABoxOutOfReachChangesNoBit) {
    const auto hashWith = [](const std::vector<StaticBox>& boxes) {
        Simulation simulation(lifted(cubeSphere(4), 0.6), Params{}, boxes);
        step(simulation, 10);
        return hashMesh(simulation.mesh()).hexadecimal();
    };
    EXPECT_EQ(hashWith({}), hashWith({{{50, 0, 0}, {1, 1, 1}}}));
    EXPECT_NE(hashWith({}), hashWith({{{0, 0.1, 0}, {0.3, 0.3, 0.3}}}));
}

TEST_F(BoxContactTest, CommandsAreCheckedAndUndone) {
    const StaticBox box{{0, -1, 0}, {1, 1, 1}};
    Simulation simulation(cubeSphere(3), withoutFloor(), {box});
    simulation.setUndoBudget(1 << 30);
    EXPECT_EQ(simulation.execute(RemoveBox{1}), "There is no box 1; they count from 0 to 0.");
    EXPECT_EQ(simulation.execute(AddBox{{{0, 0, 0}, {1, 0, 1}}}),
              "The size of a box needs three numbers from 1e-6 to 1e6 m.");
    EXPECT_EQ(simulation.execute(ChangeBox{0, {{NAN, 0, 0}, {1, 1, 1}}}),
              "The centre of a box needs three numbers from -1e8 to 1e8 m.");
    EXPECT_EQ(simulation.history().entries().size(), 0U);

    const std::string before = simulation.stateHash();
    StaticBox moved = box;
    EXPECT_EQ(simulation.execute(AddBox{box}), "");
    for (const double x : {0.1, 0.2, 0.3}) {
        moved.center.x() = x;
        EXPECT_EQ(simulation.execute(ChangeBox{1, moved, x > 0.1}), "");
    }
    EXPECT_EQ(simulation.history().entries().size(), 2U) << "one gesture is one change";
    EXPECT_EQ(simulation.execute(RemoveBox{0}), "");
    EXPECT_EQ(simulation.boxes(), std::vector<StaticBox>{moved});
    EXPECT_NE(simulation.stateHash(), before);
    simulation.execute(Undo{});
    EXPECT_EQ(simulation.boxes(), (std::vector<StaticBox>{box, moved}));
    simulation.execute(Undo{});
    EXPECT_EQ(simulation.boxes(), (std::vector<StaticBox>{box, box}));
    simulation.execute(Redo{});
    EXPECT_EQ(simulation.boxes(), (std::vector<StaticBox>{box, moved}));
    simulation.execute(Undo{});
    simulation.execute(Undo{});
    EXPECT_EQ(simulation.stateHash(), before);
    simulation.execute(RemoveBox{0});
    EXPECT_EQ(simulation.execute(RemoveBox{0}), "There is no box yet; add one first.");
    simulation.reset();
    EXPECT_EQ(simulation.boxes(), std::vector<StaticBox>{box});
}

}  // namespace
}  // namespace kerf
