#include "sim/contact/obstacles.h"
#include "tests/support/reference/reference_boxes.h"

namespace kerf {
namespace {

// A skin that lies on a corner or an edge dips behind it by less than this [m].
constexpr double kDip = 0.003;

/// How deep the edges of a box lie inside a mesh, at 17 points of each, corners among them [m].
double deepestEdgeOf(const StaticBox& box, const SurfaceMesh& mesh) {
    const Bounds around = meshBounds(mesh);
    double deepest = 0;
    const auto look = [&](const Vec3& p) {
        Bounds point;
        point.add(p);
        deepest = around.overlaps(point) ? std::max(deepest, depthInside(mesh, p)) : deepest;
    };
    for (int corner = 0; corner < 8; ++corner) {
        for (const int other : {corner | 1, corner | 2, corner | 4}) {
            const Vec3 along = box.corner(other) - box.corner(corner);
            for (int i = 0; i <= 16 && other != corner; ++i) {
                look(box.corner(corner) + along * (i / 16.0));
            }
        }
    }
    return deepest;
}

/// A model that falls on a turned box.
struct Fall {
    std::string model;
    StaticBox box;
    double height;  ///< of the lowest point above the box's highest [m]
};

Fall randomFall(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    constexpr std::array kModels{"sphere20", "sphere80", "sphere768", "octopus"};
    Fall fall;
    fall.model = kModels.at(seed % kModels.size());
    for (int axis = 0; axis < 3; ++axis) {
        fall.box.size[axis] = in(0.2, 0.7);
        fall.box.rotate[axis] = in(-60, 60);
    }
    fall.box.center = Vec3(in(-0.2, 0.2), 0, in(-0.2, 0.2));
    fall.height = in(0.05, 0.5);
    return fall;
}

/// How deep box edges get into a body [m].
struct Depths {
    double most = 0;
    double atEnd = 0;
};

void note(const StaticBox& box, const SurfaceMesh& mesh, Depths& depths) {
    depths.atEnd = deepestEdgeOf(box, mesh);
    depths.most = std::max(depths.most, depths.atEnd);
}

Depths depthsOf(const Fall& fall) {
    SurfaceMesh mesh = builtin(fall.model);
    const double top = fall.box.bounds().high.y();
    const double way = top + fall.height - meshBounds(mesh).low.y();
    mesh = movedBy(std::move(mesh), {0, way, 0});
    Params params;
    params.floor = top - 0.35;
    Simulation simulation(std::move(mesh), params, {fall.box});
    Depths depths;
    for (int i = 0; i < 200; ++i) {
        simulation.step();
        if (i % 8 == 7) {
            note(fall.box, simulation.mesh(), depths);
        }
    }
    return depths;
}

class BoxCornerTest : public GlTest {};

std::uint32_t fuzzRuns(int byDay, int byNight) {
    return static_cast<std::uint32_t>(test::runs("KERF_FUZZ_RUNS", byDay, byNight));
}

void print(std::uint32_t seed, const Depths& depths) {
    std::cout << "seed " << seed << ": box edges at most " << 1000 * depths.most
              << " mm deep, at the end " << 1000 * depths.atEnd << " mm" << std::endl;
}

TEST_F(BoxCornerTest, StaysOutOfWhatFallsOnIt) {
    const std::uint32_t first = fuzzSeed(7000);
    const std::uint32_t runs = fuzzRuns(3, 8);  // the fourth is the octopus
    for (std::uint32_t seed = first; seed < first + runs; ++seed) {
        const Depths depths = depthsOf(randomFall(seed));
        print(seed, depths);
        EXPECT_LT(depths.atEnd, kDip) << "seed " << seed;
    }
}

// A box stands in the body as it begins, its upper edge far from every face of it.
TEST_F(BoxCornerTest, LeavesABodyThatItStandsIn) {
    Params params;
    params.floor = -0.65;
    const StaticBox box{{0.15, -0.55, 0}, {0.25, 0.577, 0.577}, {0, 0, 30}};
    Simulation simulation(builtin("sphere768"), params, {box});
    EXPECT_GT(deepestEdgeOf(box, simulation.mesh()), 0.2);
    step(simulation, 170);
    EXPECT_LT(deepestEdgeOf(box, simulation.mesh()), kDip);
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
}

/// A turned box that somebody moves into a body from one side, its middle to the skin, and leaves.
Depths depthsOfPush(std::uint32_t seed) {
    Fall push = randomFall(seed);
    std::mt19937 random(seed);
    const double angle = static_cast<double>(random()) / 4294967296.0 * 2 * M_PI;
    const Vec3 from(std::cos(angle), 0.1, std::sin(angle));
    Params params;
    params.floor = -0.51;
    const char* model = seed % 2 == 0 ? "sphere80" : "sphere768";
    push.box.center = 1.15 * from;
    Simulation simulation(builtin(model), params, {push.box});
    Depths depths;
    for (int i = 0; i < 120; ++i) {
        if (i < 40 && i % 4 == 0) {
            push.box.center -= 0.06 * from;
            EXPECT_EQ(simulation.execute(ChangeBox{0, push.box}), "");
        }
        simulation.step();
        if (i % 8 == 7) {
            note(push.box, simulation.mesh(), depths);
        }
    }
    EXPECT_NEAR(simulation.report().volumeRatio, 1, 1e-3);
    return depths;
}

TEST_F(BoxCornerTest, LeavesABodyThatItIsMovedInto) {
    const std::uint32_t first = fuzzSeed(7000);
    const std::uint32_t runs = fuzzRuns(2, 8);
    for (std::uint32_t seed = first; seed < first + runs; ++seed) {
        const Depths depths = depthsOfPush(seed);
        print(seed, depths);
        EXPECT_LT(depths.atEnd, kDip) << "seed " << seed;
    }
}

/// A cube that reaches 2 cm into a sphere of radius 0.5 with what lies in this direction of it.
StaticBox touching(const Vec3& direction, const Vec3& turn) {
    const Vec3 size = Vec3::Constant(0.5);
    const double reach = 0.5 * size.cwiseProduct(direction).norm();
    return {-(turnOf(turn) * direction.normalized()) * (0.48 + reach), size, turn};
}

/// A body in motion that boxes touch at corners and edges, and one of which stands in it.
struct TouchedBody {
    TouchedBody() : model(buildBodyModel(cubeSphere(5))) {
        params.gravity.setZero();
        params.timeStep = 0.00025;
        params.iterations = 1;
        params.floor.reset();
        settings = contactSettings(params);
        settings.enabled = false;
        state = stateOf(cubeSphere(5));
        std::mt19937 random(kSeed);
        std::uniform_real_distribution<float> noise(-1, 1);
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            const auto vector = [&] { return Vec3f(noise(random), noise(random), noise(random)); };
            state.positions[v] += 0.005F * vector();
            state.velocities[v] = vector();
        }
        solver.setModel(model, state);
        shared::SolverUniforms uniforms = solverUniforms(params);
        uniforms.active_parts = 0;
        solver.setUniforms(uniforms);
        solver.collisions().setSettings(settings);
        solver.collisions().setBoxes(boxes);
    }

    ReferenceState reference() const {
        ReferenceState result = restState(model);
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            result.positions[v] = state.positions[v].cast<double>();
            result.velocities[v] = state.velocities[v].cast<double>();
            result.displacements[v] = settings.substep * result.velocities[v];
        }
        return result;
    }

    ReferenceBoxes referenceBoxes() const {
        std::vector<double> inverse;
        for (const double mass : unitMasses(model)) {
            inverse.push_back(mass > 0 ? settings.inverseDensity / mass : 0.0);
        }
        const TouchDistances distances =
            BoxObstacles(boxes).distances(settings, contactEdgeLength(model));
        return {model, boxes, settings, distances, inverse};
    }

    static constexpr unsigned kSeed = 23;
    std::vector<StaticBox> boxes{{{0.05, -0.62, 0.02}, {0.4, 0.7, 0.5}, {20, 30, 40}},
                                 touching(Vec3(1, 1, 1), {10, 20, 30}),
                                 touching(Vec3(-1, 1, 0), {-40, 10, 15})};
    BodyModel model;
    Params params = plainPbd();
    ContactSettings settings;
    BodyState state;
    GpuSolver solver;
};

/// Whether what keeps vertices out of boxes may have the last word on one.
bool mayEnter(const std::vector<StaticBox>& boxes, const Vec3& x, const Vec3& d, double room) {
    return std::ranges::any_of(boxes, [&](const StaticBox& box) {
        const Vec3 at = (box.axes().transpose() * (x - box.center)).cwiseAbs();
        return ((at - 0.5 * box.size).array() < room + d.norm()).all();
    });
}

TEST_F(BoxCornerTest, TrianglesAnswerLikeTheReference) {
    TouchedBody body;
    SCOPED_TRACE("seed " + std::to_string(TouchedBody::kSeed));
    ReferenceState reference = body.reference();
    const ReferenceBoxes::Counts counts = body.referenceBoxes().respond(reference);
    EXPECT_GT(counts.touched, 5);
    EXPECT_GE(counts.passed, 3);

    Bounds positions;
    Bounds velocities;
    for (std::size_t v = 0; v < body.state.positions.size(); ++v) {
        positions.add(body.state.positions[v].cast<double>());
        velocities.add(body.state.velocities[v].cast<double>());
    }
    Collisions& collisions = body.solver.collisions();
    collisions.expect(positions, velocities);
    collisions.beginStep(nullptr);
    body.solver.predictAndStretch();
    collisions.beginSubstep();
    collisions.respond();
    const std::vector<Vec3f> ours = body.solver.readDisplacements();
    const BodyState after = body.solver.readState();
    const ReferenceState before = body.reference();
    int compared = 0;
    for (std::size_t v = 0; v < ours.size(); ++v) {
        const Vec3& x = reference.positions[v];
        const Vec3& d = reference.displacements[v];
        EXPECT_LT((after.positions[v].cast<double>() - x).norm(), 2e-7) << v;
        if (!mayEnter(body.boxes, x, d, 0.01)) {
            EXPECT_LT((ours[v].cast<double>() - d).norm(), 1e-8) << v;
            compared += (d - before.displacements[v]).norm() > 1e-5;
        }
    }
    EXPECT_GE(compared, 3);
}

}  // namespace
}  // namespace kerf
