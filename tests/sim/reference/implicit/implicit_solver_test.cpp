#include "tests/support/reference/implicit/implicit_solver.h"

#include "tests/support/reference/implicit/surface_contacts.h"

namespace kerf {
namespace {

Params materialOf(double modulus) {
    Params params;
    params.youngsModulus = modulus;
    params.airDrag = 0;
    params.gravity.setZero();
    return params;
}

BodyModel ball() {
    return cutBallModel(1);
}
BodyModel slitBall() {
    return cutBallModel(-0.03);
}
BodyModel halves() {
    return cutBallModel(-0.12);
}

void run(ImplicitReference& solver, ReferenceState& state, double seconds, double step) {
    for (int i = 0; i < std::lround(seconds / step); ++i) {
        solver.step(state);
    }
}

struct Momentum {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

Momentum momentumOf(const ImplicitReference& solver, const ReferenceState& state) {
    Momentum momentum;
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const Vec3 part = solver.masses()[v] * state.velocities[v];
        momentum.linear += part;
        momentum.angular += state.positions[v].cross(part);
    }
    return momentum;
}

double rmsBetween(const Vectors& a, const Vectors& b) {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
        sum += (a[v] - b[v]).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// At rest to what floats say of lengths and angles.
TEST(ImplicitReference, FallsAsFarAsGravitySays) {
    const BodyModel model = ball();
    ImplicitSettings settings = implicitSettings(materialOf(1e5));
    settings.gravity = {0, -9.81, 1};
    ImplicitReference solver(model, settings);
    ReferenceState state = restState(model);
    run(solver, state, 0.25, settings.step);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const Vec3 fall = state.positions[v] - model.restPositions[v].cast<double>();
        EXPECT_LT((fall - 0.5 * 0.25 * 0.25 * settings.gravity).norm(), 1e-5);
        EXPECT_LT((state.velocities[v] - 0.25 * settings.gravity).norm(), 3e-5);
    }
}

TEST(ImplicitReference, KeepsMomentum) {
    const BodyModel model = ball();
    const ImplicitSettings settings = implicitSettings(materialOf(1e5));
    ImplicitReference solver(model, settings);
    ReferenceState state = restState(model);
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
        const Vec3 p = state.positions[v];
        state.velocities[v] =
            Vec3(0.7, 0.4, 0.2) + Vec3(3, 1, 0.5).cross(p) + Vec3(2 * p.y(), -p.z(), p.x());
    }
    const Momentum before = momentumOf(solver, state);
    const double energy = solver.energy(state);
    run(solver, state, 0.2, settings.step);
    const Momentum after = momentumOf(solver, state);
    EXPECT_LT((after.linear - before.linear).norm(), 1e-9 * before.linear.norm());
    // Each step turns the body along its tangents.
    EXPECT_LT((after.angular - before.angular).norm(), 0.05 * before.angular.norm());
    EXPECT_LT(solver.energy(state), energy);
    EXPECT_GT(solver.energy(state), 0.97 * energy);
}

/// How far a slit ball whose lowest part is pinned has moved after 0.1 s of a sidewise pull.
Vectors swingOf(const BodyModel& model, double step, int iterations, int passes) {
    ImplicitSettings settings = implicitSettings(materialOf(3e4));
    settings.step = step;
    settings.iterations = iterations;
    settings.passes = passes;
    settings.tolerance = passes > 1 ? 1e-8 : 0;
    settings.gravity = {0, -4, 9};
    ImplicitReference solver(model, settings, verticesBelow(model, -0.08));
    ReferenceState state = restState(model);
    run(solver, state, 0.1, step);
    return state.positions;
}

TEST(ImplicitReference, ErrsByTheSquareOfTheStep) {
    const BodyModel model = ball();
    const Vectors truth = swingOf(model, 1.0 / 3840, 200, 2);
    const double coarse = rmsBetween(swingOf(model, 1.0 / 240, 200, 2), truth);
    const double fine = rmsBetween(swingOf(model, 1.0 / 480, 200, 2), truth);
    EXPECT_GT(coarse / fine, 3);
    EXPECT_LT(coarse / fine, 6);
}

TEST(ImplicitReference, FourIterationsOpenASlitAsManyDo) {
    const BodyModel model = slitBall();
    const Vectors truth = swingOf(model, 1.0 / 960, 200, 2);
    const double way = rmsBetween(truth, restState(model).positions);
    EXPECT_LT(rmsBetween(swingOf(model, 1.0 / 240, 4, 1), truth), 0.05 * way);
}

TEST(ImplicitReference, ABodyAtRestStaysAtRest) {
    const BodyModel model = slitBall();
    for (const int iterations : {1, 4}) {
        ImplicitSettings settings = implicitSettings(materialOf(1e6));
        settings.iterations = iterations;
        ImplicitReference solver(model, settings);
        ReferenceState state = restState(model);
        run(solver, state, 0.5, settings.step);
        EXPECT_LT(rmsBetween(state.positions, restState(model).positions), 1e-7);
    }
}

TEST(ImplicitReference, StormsCalmDown) {
    std::mt19937 random(fuzzSeed(7));
    std::uniform_real_distribution<double> speed(-2, 2);
    for (const BodyModel& model : {slitBall(), halves()}) {
        for (const auto& [step, iterations] : {std::pair(1.0 / 240, 4), {1.0 / 120, 8}}) {
            ImplicitSettings settings = implicitSettings(materialOf(3e5));
            settings.step = step;
            settings.iterations = iterations;
            ImplicitReference solver(model, settings);
            ReferenceState state = restState(model);
            for (Vec3& v : state.velocities) {
                v = {speed(random), speed(random), speed(random)};
            }
            double energy = solver.energy(state);
            for (int i = 0; i < 24; ++i) {
                solver.step(state);
                const double now = solver.energy(state);
                EXPECT_LT(now, 1.001 * energy) << "step " << i;
                energy = now;
            }
        }
    }
}

TEST(ImplicitReference, KeepsVolumes) {
    const BodyModel model = halves();
    ImplicitSettings settings = implicitSettings(materialOf(2e4));
    settings.gravity = {0, -9.81, 0};
    ImplicitReference solver(model, settings, verticesBelow(model, -0.08));
    ReferenceState state = restState(model);
    run(solver, state, 0.2, settings.step);
    const std::vector<double> volumes = solver.volumes(state.positions);
    for (std::size_t p = 0; p < volumes.size(); ++p) {
        EXPECT_NEAR(volumes[p] / model.pieces[p].restVolume, 1, 1e-3);
    }
}

/// The speed at which a ball bounces off the floor.
double reboundOf(double step, int iterations, int passes) {
    const BodyModel model = ball();
    ImplicitSettings settings = implicitSettings(materialOf(1e5));
    settings.step = step;
    settings.iterations = iterations;
    settings.passes = passes;
    settings.tolerance = passes > 1 ? 1e-5 : 0;
    ImplicitReference solver(model, settings);
    SurfaceContacts floor(model, 0.5, -0.102, false);
    solver.setContacts(&floor);
    ReferenceState state = restState(model);
    for (Vec3& v : state.velocities) {
        v = {0, -0.7, 0};
    }
    const double energy = solver.energy(state);
    double mass = 0;
    for (const double m : solver.masses()) {
        mass += m;
    }
    double fastest = 0;
    for (int i = 0; i < std::lround(0.1 / step); ++i) {
        solver.step(state);
        EXPECT_LT(solver.energy(state), energy * 1.0001);
        fastest = std::max(fastest, momentumOf(solver, state).linear.y() / mass);
    }
    return fastest;
}

TEST(ImplicitReference, ReboundsAsAFineStepDoes) {
    const double truth = reboundOf(1.0 / 1920, 40, 2);
    EXPECT_GT(truth, 0.2);
    EXPECT_NEAR(reboundOf(1.0 / 240, 8, 1), truth, 0.1 * truth);
}

TEST(ImplicitReference, HalvesRestOnEachOther) {
    const BodyModel model = halves();
    ImplicitSettings settings = implicitSettings(materialOf(1e5));
    settings.gravity = {0, -0.5, -9.8};  // the cut lies level
    settings.drag = 5;
    settings.iterations = 8;
    std::vector<std::uint32_t> pinned;
    for (std::uint32_t v = 0; v < model.restPositions.size(); ++v) {
        if (model.restPositions[v].z() < -0.07F) {
            pinned.push_back(v);
        }
    }
    ImplicitReference solver(model, settings, pinned);
    SurfaceContacts surfaces(model, 0.5, {});
    solver.setContacts(&surfaces);
    ReferenceState state = restState(model);
    run(solver, state, 0.8, settings.step);
    EXPECT_GT(solver.step(state).pushing, 20);
    for (const Vec3& v : state.velocities) {
        EXPECT_LT(v.norm(), 2e-3);
    }
    EXPECT_LT(rmsBetween(state.positions, restState(model).positions), 0.01);
}

}  // namespace
}  // namespace kerf
