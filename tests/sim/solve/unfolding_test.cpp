#include "sim/solve/time_stepper.h"
#include "tests/support/folds.h"
#include "tests/support/reference/reference_solver.h"
#include "tests/support/reference/reference_unfolding.h"

namespace kerf {
namespace {

/// A weightless body whose vertices were moved at random, and have random velocities.
struct Crumpled {
    /// `reach`: of each coordinate, in mean edge lengths. `speed` [m/s].
    Crumpled(SurfaceMesh body, float reach, float speed)
        : mesh(std::move(body)), model(buildBodyModel(mesh)) {
        Params params;
        params.gravity = Vec3::Zero();
        params.floor.reset();
        uniforms = solverUniforms(params, model);
        std::mt19937 random(5);
        std::uniform_real_distribution<float> noise(-1, 1);
        const auto vector = [&] { return Vec3f(noise(random), noise(random), noise(random)); };
        reach *= static_cast<float>(meanRestEdgeLength(mesh));
        for (const Vec3f& p : model.restPositions) {
            start.positions.push_back(p + reach * vector());
            start.velocities.push_back(speed * vector());
        }
        gpu.setModel(model, start);
        gpu.setUniforms(uniforms);
    }

    void unfoldFirmly(bool firmly) {
        uniforms.active_parts &= ~shared::kUnfoldFirmlyPart;
        uniforms.active_parts |= firmly ? shared::kUnfoldFirmlyPart : 0u;
        gpu.unfoldFirmly(firmly);
    }

    ReferenceState startInDoubles() const {
        ReferenceState state = restState(model);
        for (std::size_t v = 0; v < start.positions.size(); ++v) {
            state.positions[v] = start.positions[v].cast<double>();
            state.velocities[v] = start.velocities[v].cast<double>();
        }
        return state;
    }

    /// Edges folded by more than 90 degrees.
    int folds() {
        const BodyState now = gpu.readState();
        for (std::size_t v = 0; v < now.positions.size(); ++v) {
            mesh.setPosition(static_cast<int>(v), now.positions[v].cast<double>());
        }
        return foldedEdges(mesh);
    }

    SurfaceMesh mesh;
    BodyModel model;
    shared::SolverUniforms uniforms;
    BodyState start;
    GpuSolver gpu;
};

struct Difference {
    double change = 0;  ///< largest, that the reference makes
    double error = 0;   ///< largest, between both
};

Difference differenceOf(const std::vector<Vec3f>& now, const std::vector<Vec3>& reference,
                        const std::vector<Vec3f>& start) {
    Difference difference;
    for (std::size_t v = 0; v < now.size(); ++v) {
        difference.change =
            std::max(difference.change, (reference[v] - start[v].cast<double>()).norm());
        difference.error =
            std::max(difference.error, (now[v].cast<double>() - reference[v]).norm());
    }
    return difference;
}

class UnfoldingTest : public GlTest {};

void expectSameUnfolding(Crumpled& body) {
    body.gpu.setState(body.start);
    ReferenceState reference = body.startInDoubles();
    const ReferenceSolver solver(body.model, body.uniforms);
    unfoldAsReference(body.model, solver.inverseMasses(), body.uniforms, reference);
    body.gpu.stepper().unfold();
    const BodyState now = body.gpu.readState();
    const Difference difference =
        differenceOf(now.velocities, reference.velocities, body.start.velocities);
    EXPECT_EQ(now.positions, body.start.positions);
    EXPECT_GT(difference.change, 1);
    EXPECT_LT(difference.error, 1e-4 * difference.change);
}

class FirmAndGentleUnfoldingTest : public UnfoldingTest,
                                   public ::testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(Firmly, FirmAndGentleUnfoldingTest, ::testing::Bool());

TEST_P(FirmAndGentleUnfoldingTest, DoesWhatTheReferenceDoes) {
    for (const SurfaceMesh& mesh : {cubeSphere(8), torus(), bentTube()}) {
        Crumpled body(mesh, 0.4f, 1.0f);
        body.unfoldFirmly(GetParam());
        EXPECT_GT(body.folds(), 10);
        expectSameUnfolding(body);
    }
}

TEST_P(FirmAndGentleUnfoldingTest, KeepsMomentum) {
    Crumpled body(cubeSphere(8), 0.4f, 1.0f);
    body.unfoldFirmly(GetParam());
    body.gpu.stepper().unfold();
    const BodyState now = body.gpu.readState();
    const std::vector<double> masses = unitMasses(body.model);
    Vec3 gained = Vec3::Zero();
    Vec3 turned = Vec3::Zero();
    double moved = 0;
    for (std::size_t v = 0; v < masses.size(); ++v) {
        const Vec3 change =
            masses[v] * (now.velocities[v] - body.start.velocities[v]).cast<double>();
        gained += change;
        turned += body.start.positions[v].cast<double>().cross(change);
        moved += change.norm();
    }
    EXPECT_LT(gained.norm(), 1e-6 * moved);
    EXPECT_LT(turned.norm(), 1e-5 * moved);  // the body's radius is 0.5 m
}

TEST_F(UnfoldingTest, ChangesNoBitWhereNothingIsFolded) {
    Crumpled body(cubeSphere(8), 0.05f, 1.0f);
    body.gpu.stepper().unfold();
    const BodyState now = body.gpu.readState();
    EXPECT_EQ(now.positions, body.start.positions);
    EXPECT_EQ(now.velocities, body.start.velocities);
}

// Thin triangles turn over without a bend before: their apex slides over the edge below it.
TEST_F(UnfoldingTest, HoldsATriangleThatIsSquashedInItsPlane) {
    Crumpled body(cubeSphere(8), 0.0f, 0.0f);
    const auto [a, b, apex] = body.mesh.triangle(0);
    BodyState state = body.start;
    const Vec3f foot = (state.positions[a] + state.positions[b]) / 2;
    const Vec3f height = state.positions[apex] - foot;
    const auto pullAt = [&, apex = apex](float share) {
        state.positions[apex] = foot + share * height;
        body.gpu.setState(state);
        EXPECT_EQ(body.folds(), 0);
        body.gpu.stepper().unfold();
        return body.gpu.readState().velocities[apex].dot(height.normalized());
    };
    EXPECT_EQ(pullAt(0.6f), 0.0f);
    EXPECT_GT(pullAt(0.3f), 0.01f);
    EXPECT_GT(pullAt(0.1f), pullAt(0.3f));
}

}  // namespace
}  // namespace kerf
