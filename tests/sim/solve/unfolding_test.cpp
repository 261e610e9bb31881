#include "sim/solve/unfolding.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "sim/body/piece_masses.h"
#include "sim/body/rest_geometry.h"
#include "sim/body/solver_uniforms.h"
#include "sim/run/simulation.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/folds.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/reference/reference_solver.h"
#include "tests/support/shape_error.h"
#include "tests/support/shapes.h"
#include "tests/support/small_steps.h"

namespace kerf {
namespace {

/// A weightless body whose vertices were moved at random, and have random velocities.
struct Crumpled {
    /// `reach`: of each coordinate, in mean edge lengths. `speed` [m/s].
    Crumpled(SurfaceMesh body, float reach, float speed)
        : mesh(std::move(body)), model(buildBodyModel(mesh)) {
        Params params = test::smallSteps();
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

    void useTrueModulus() {
        uniforms.active_parts |= shared::kTrueModulusPart;
        gpu.setUniforms(uniforms);
    }

    ReferenceState startInDoubles() const {
        ReferenceState state = restState(model);
        for (std::size_t v = 0; v < start.positions.size(); ++v) {
            state.positions[v] = start.positions[v].cast<double>();
            state.velocities[v] = start.velocities[v].cast<double>();
        }
        return state;
    }

    void play(int steps) {
        for (int step = 0; step < steps; ++step) {
            gpu.measure();
            gpu.step();
        }
    }

    /// Edges folded by more than 90 degrees.
    int folds() {
        const BodyState now = gpu.readState();
        for (std::size_t v = 0; v < now.positions.size(); ++v) {
            mesh.setPosition(static_cast<int>(v), now.positions[v].cast<double>());
        }
        return test::foldedEdges(mesh);
    }

    /// As of the last folds() [m].
    double shapeError() const {
        std::vector<int> all(mesh.positions().size());
        std::iota(all.begin(), all.end(), 0);
        return test::rmsShapeError(mesh.restPositions(), mesh.positions(), all);
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

class UnfoldingTest : public test::GlTest {};

void expectSameUnfolding(Crumpled& body) {
    body.gpu.setState(body.start);
    ReferenceState reference = body.startInDoubles();
    ReferenceSolver(body.model, body.uniforms).unfold(reference);
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
    for (const SurfaceMesh& mesh : {test::cubeSphere(8), test::torus(), test::bentTube()}) {
        Crumpled body(mesh, 0.4f, 1.0f);
        body.unfoldFirmly(GetParam());
        EXPECT_GT(body.folds(), 10);
        expectSameUnfolding(body);
        body.useTrueModulus();
        expectSameUnfolding(body);
    }
}

// On folded skin constraints are bounded instead of damped, and the floor does not rub.
TEST_F(UnfoldingTest, AStepIsThatOfTheReference) {
    for (const bool oneGroup : {true, false}) {
        Crumpled body(test::cubeSphere(8), 0.3f, 0.5f);
        body.uniforms.active_parts |= shared::kFloorPart;
        body.uniforms.floor_height = -0.3f;
        body.uniforms.substeps = 2;
        body.gpu.setUniforms(body.uniforms);
        body.gpu.stepper().allowOneGroup(oneGroup);
        ReferenceState reference = body.startInDoubles();
        ReferenceSolver(body.model, body.uniforms).step(reference);
        body.play(1);
        const BodyState now = body.gpu.readState();
        const Difference difference =
            differenceOf(now.positions, reference.positions, body.start.positions);
        EXPECT_LT(difference.error, 1e-3 * difference.change);
    }
}

/// Besides the seven of a substep three, and one at the start of a step.
TEST_F(UnfoldingTest, TakesThreeDispatchesASubstep) {
    Crumpled body(test::cubeSphere(8), 0.3f, 0.5f);
    body.gpu.stepper().allowOneGroup(false);
    body.gpu.measure();
    const long before = body.gpu.dispatches();
    body.gpu.step();
    EXPECT_TRUE(body.gpu.stepper().unfolds());
    EXPECT_LE(body.gpu.dispatches() - before, 10L * body.uniforms.substeps + 1);
}

TEST_P(FirmAndGentleUnfoldingTest, KeepsMomentum) {
    Crumpled body(test::cubeSphere(8), 0.4f, 1.0f);
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
    Crumpled body(test::cubeSphere(8), 0.05f, 1.0f);
    body.gpu.stepper().unfold();
    const BodyState now = body.gpu.readState();
    EXPECT_EQ(now.positions, body.start.positions);
    EXPECT_EQ(now.velocities, body.start.velocities);
}

// Thin triangles turn over without a bend before: their apex slides over the edge below it.
TEST_F(UnfoldingTest, HoldsATriangleThatIsSquashedInItsPlane) {
    Crumpled body(test::cubeSphere(8), 0.0f, 0.0f);
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

/// What points touched in the last substep, and how much of it was folded: what lay closer to them
/// at rest than contact keeps its whole thickness from, other parts of their piece, other pieces.
struct Touched {
    int walls = 0, foldedWalls = 0;
    int own = 0, foldedOwn = 0;
    int others = 0, foldedOthers = 0;
};

Touched countTouched(const Crumpled& body, const std::vector<double>& folds, double thickness) {
    const ContactSolver& contacts = body.gpu.collisions().contacts();
    const auto candidates = contacts.readCandidates();
    const auto isWall = [&](std::uint32_t point, std::uint32_t corner) {
        return std::ranges::any_of(candidates[point], [&](const shared::ContactCandidate& c) {
            return body.model.triangles[c.triangle][0] == corner && c.thickness < thickness;
        });
    };
    const std::vector<int>& pieces = body.model.pieceOfVertex;
    Touched touched;
    for (const shared::ContactRecord& record :
         contacts.records().read<shared::ContactRecord>(0, contacts.readState().points)) {
        if (record.v1 == shared::kNoVertex) {
            continue;
        }
        const bool own = pieces[record.v0] == pieces[record.v1];
        const bool folded =
            std::max({folds[record.v0], folds[record.v1], folds[record.v2], folds[record.v3]}) > 0;
        const bool wall = isWall(record.v0, record.v1);
        (wall ? touched.walls : own ? touched.own : touched.others) += 1;
        (wall ? touched.foldedWalls : own ? touched.foldedOwn : touched.foldedOthers) += folded;
    }
    return touched;
}

/// One substep with contact.
Touched touchedBy(Crumpled& body) {
    Params params = test::smallSteps();
    params.contact = 1;
    ContactSettings settings = contactSettings(params);
    settings.edges = false;
    body.gpu.collisions().setSettings(settings);
    body.uniforms.substeps = 1;
    body.gpu.setUniforms(body.uniforms);
    ReferenceState reference = body.startInDoubles();
    ReferenceSolver(body.model, body.uniforms).unfold(reference);
    EXPECT_GT(std::ranges::count_if(reference.folds, [](double fold) { return fold > 0; }), 20);
    body.play(1);
    const double thickness = 0.999 * settings.thickness * contactEdgeLength(body.model);
    return countTouched(body, reference.folds, thickness);
}

/// One side of the slit moved along the other, by so many edges that they face walls which lay far
/// from them at rest.
void slideWalls(Crumpled& body) {
    const Vec3f way(static_cast<float>(2.5 * meanRestEdgeLength(body.mesh)), 0, 0);
    std::set<int> side;
    for (int t = 0; t < body.mesh.triangleSlots(); ++t) {
        if (body.mesh.alive(t) && body.mesh.wallLabel(t) >= 0 && body.mesh.wallLabel(t) % 2 == 1) {
            side.insert(body.mesh.triangle(t).begin(), body.mesh.triangle(t).end());
        }
    }
    for (const int v : side) {
        body.start.positions[v] += way;
    }
    body.gpu.setState(body.start);
}

// A wall that has turned over would be caught behind the other one.
TEST_F(UnfoldingTest, FoldedWallsDoNotTouch) {
    Crumpled body(test::slitSphere(), 0.15f, 0.5f);
    const Touched touched = touchedBy(body);
    EXPECT_GT(touched.walls, 5);
    EXPECT_EQ(touched.foldedWalls, 0);
}

/// What a slit of so many steps touches (test::slitSphere) with its walls slid along each other.
Touched touchedBySlidWalls(int steps) {
    Crumpled body(test::slitSphere(steps), 0.15f, 0.5f);
    slideWalls(body);
    return touchedBy(body);
}

TEST_F(UnfoldingTest, FoldedSkinDoesNotTouchItsOwnPiece) {
    const Touched touched = touchedBySlidWalls(16);
    EXPECT_GT(touched.own, 2);
    EXPECT_EQ(touched.foldedOwn, 0);
}

// Else what lies on another piece would fall through it.
TEST_F(UnfoldingTest, FoldedSkinTouchesOtherPieces) {
    const Touched touched = touchedBySlidWalls(30);
    EXPECT_GT(touched.others, 5);
    EXPECT_GT(touched.foldedOthers, 5);
}

TEST_F(UnfoldingTest, FirmlyItHoldsMoreOfALoad) {
    const auto foldsUnderLoad = [](bool firmly) {
        Crumpled body(test::cubeSphere(8), 0.0f, 0.0f);
        body.uniforms.active_parts |= shared::kFloorPart;
        body.uniforms.floor_height = -0.5f;
        body.uniforms.gravity = {0, -400.0f, 0, 0};
        body.gpu.setUniforms(body.uniforms);
        body.unfoldFirmly(firmly);
        int most = 0;
        for (int i = 0; i < 60; ++i) {
            body.play(1);
            most += body.folds();
        }
        return most;
    };
    const int gently = foldsUnderLoad(false);
    const int firmly = foldsUnderLoad(true);
    EXPECT_GT(gently, 0);
    EXPECT_LT(firmly, gently);
}

// A spring that gave energy would shake the body for ever.
TEST_P(FirmAndGentleUnfoldingTest, BringsACrumpledBodyBackToItsShapeAndToRest) {
    Crumpled body(test::cubeSphere(8), 0.8f, 0.0f);
    body.unfoldFirmly(GetParam());
    EXPECT_GT(body.folds(), 100);
    body.play(300);
    EXPECT_EQ(body.folds(), 0);
    EXPECT_LT(body.shapeError(), 0.05 * meanRestEdgeLength(body.mesh));
}

}  // namespace
}  // namespace kerf
