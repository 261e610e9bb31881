#include "sim/contact/contact_solver.h"

#include "tests/support/reference/reference_contact.h"

namespace kerf {
namespace {

constexpr unsigned kContactSeed = 11;

Params withContact() {
    Params params;
    params.contact = 1;
    return params;
}

Params withoutWeight() {
    Params params = withContact();
    params.gravity.setZero();
    params.floor.reset();
    return params;
}

/// Two spheres that reach a little into each other.
SurfaceMesh twoSpheres() {
    return meshOf(joined(cubeSphereSoup(5, 0.4), icosphereSoup(2, 0.4), {0.05, 0.7, 0.02}));
}

/// A beam at rest that stands there bent round, so that its ends reach into each other.
SurfaceMesh bentRound() {
    SurfaceMesh mesh = box({3, 0.3, 0.3}, 16);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 p = mesh.restPosition(v);
        const double angle = p.x() * 2.15;
        const double radius = 0.48 + p.y();
        mesh.setPosition(v, {radius * std::sin(angle), radius * std::cos(angle), p.z()});
    }
    return mesh;
}

/// A body in motion on the GPU and as the reference has it.
struct Pair {
    explicit Pair(const SurfaceMesh& mesh, double edgeLength = 0, double timeStep = 0.005)
        : model(buildBodyModel(mesh)) {
        if (edgeLength > 0) {
            model.edgeLength = edgeLength;
        }
        params = plainPbd(withoutWeight());
        params.timeStep = timeStep;
        params.iterations = 1;
        settings = contactSettings(params);
        settings.edges = false;  // the reference knows vertices alone
        BodyState start = stateOf(mesh);
        std::mt19937 random(kContactSeed);
        std::uniform_real_distribution<float> noise(-1, 1);
        const float reach = 0.01f * static_cast<float>(contactEdgeLength(model));
        for (std::size_t v = 0; v < start.positions.size(); ++v) {
            const auto vector = [&] { return Vec3f(noise(random), noise(random), noise(random)); };
            start.positions[v] += reach * vector();
            start.velocities[v] = vector();
        }
        gpu.setModel(model, start);
        gpu.setUniforms(solverUniforms(params));
        gpu.collisions().setSettings(settings);
        reference = restState(model);
        Bounds speeds;
        for (std::size_t v = 0; v < start.positions.size(); ++v) {
            reference.positions[v] = start.positions[v].cast<double>();
            reference.velocities[v] = start.velocities[v].cast<double>();
            speeds.add(reference.velocities[v]);
        }
        uniforms = contactUniforms(settings, contactEdgeLength(model), speeds.diagonal());
    }

    ReferenceContact referenceContact() const {
        std::vector<double> inverse;
        for (const double mass : unitMasses(model)) {
            inverse.push_back(mass > 0 ? settings.inverseDensity / mass : 0.0);
        }
        return {model, uniforms, inverse};
    }

    BodyModel model;
    ContactSettings settings;
    Params params;
    shared::ContactUniforms uniforms;
    ReferenceState reference;
    GpuSolver gpu;
};

class ContactSolverTest : public GlTest {};

/// As the beginning of a step does.
void searchAnew(Collisions& collisions) {
    collisions.beginStep(nullptr);
    collisions.search();
}

/// Searches, and returns how many candidates were found.
int expectCandidatesOfTheReference(Pair& pair) {
    searchAnew(pair.gpu.collisions());
    const auto ours = pair.gpu.collisions().contacts().readCandidates();
    const auto theirs = pair.referenceContact().findCandidates(pair.reference);
    EXPECT_EQ(ours.size(), theirs.size());
    int found = 0;
    for (std::size_t v = 0; v < std::min(ours.size(), theirs.size()); ++v) {
        SCOPED_TRACE("vertex " + std::to_string(v));
        EXPECT_EQ(ours[v].size(), theirs[v].size());
        for (std::size_t k = 0; k < std::min(ours[v].size(), theirs[v].size()); ++k) {
            EXPECT_EQ(ours[v][k].triangle, theirs[v][k].triangle);
            EXPECT_NEAR(ours[v][k].thickness, theirs[v][k].thickness, 1e-7);
            ++found;
        }
    }
    return found;
}

TEST_F(ContactSolverTest, FindsTheCandidatesOfTheReference) {
    for (const SurfaceMesh& mesh : {twoSpheres(), bentRound(), slitSphere()}) {
        SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices, seed " +
                     std::to_string(kContactSeed));
        Pair pair(mesh);
        EXPECT_GT(expectCandidatesOfTheReference(pair), 50);
    }
}

// Pieces much finer than the edge length that contact goes by, as where a coarse body was cut into
// many: llvmpipe ends a kernel's loops after 65,535 turns in all.
TEST_F(ContactSolverTest, FindsThemInACrowd) {
    SCOPED_TRACE("seed " + std::to_string(kContactSeed));
    Pair pair(meshOf(joined(cubeSphereSoup(32, 0.4), cubeSphereSoup(32, 0.4), {0.05, 0.7, 0.02})),
              0.5);
    EXPECT_GT(expectCandidatesOfTheReference(pair), 10000);
}

std::vector<std::vector<std::uint32_t>> candidatesOf(GpuSolver& solver) {
    searchAnew(solver.collisions());
    std::vector<std::vector<std::uint32_t>> out;
    for (const auto& found : solver.collisions().contacts().readCandidates()) {
        out.emplace_back();
        for (const shared::ContactCandidate& candidate : found) {
            out.back().push_back(candidate.triangle);
        }
    }
    return out;
}

// The order in which triangles are looked through is kept while a body is cut.
TEST_F(ContactSolverTest, FindsTheSameWhileItIsCutAsInTheModelWhole) {
    SurfaceMesh mesh = icosphere(3);
    BodyUpdater body(mesh);
    const Params params = withoutWeight();
    GpuSolver followed;
    followed.setModel(body.model(), stateOf(mesh));
    Cutter cutter(mesh, exactSettings());
    const Stroke stroke = straightStroke(Vec3(0.013, 0.021, 0.034), Vec3(1, 0.05, 0.1).normalized(),
                                         -Vec3::UnitY(), 3, 2, 12);
    std::size_t found = 0;
    eachStep(cutter, stroke, [&](const CutResult& result) {
        if (result.delta.empty()) {
            return;
        }
        followCut(followed, body, mesh, result.delta);
        GpuSolver fresh;
        fresh.setModel(body.model(), stateOf(mesh));
        for (GpuSolver* solver : {&followed, &fresh}) {
            solver->setUniforms(solverUniforms(params, body.model()));
            solver->collisions().setSettings(contactSettings(params));
        }
        const auto ours = candidatesOf(followed);
        EXPECT_EQ(ours, candidatesOf(fresh));
        for (const auto& triangles : ours) {
            found += triangles.size();
        }
    });
    EXPECT_GT(found, 500U);
}

/// Whether the directions from the middles of their spheres to a vertex and to a triangle oppose
/// each other clearly, whatever the bodies do meanwhile.
bool clearlyOpposed(const BodyModel& model, std::size_t v, std::uint32_t triangle) {
    const auto outward = [&](std::size_t u) {
        const Vec3 middle = model.pieceOfVertex[u] == 0 ? Vec3(0, 0, 0) : Vec3(0.05, 0.7, 0.02);
        return Vec3((model.restPositions[u].cast<double>() - middle).normalized());
    };
    return outward(v).dot(outward(model.triangles[triangle][0])) < -0.4;
}

// Looked for anew with no more than half an edge to spare, nothing may turn up that is not kept.
TEST_F(ContactSolverTest, KeptCandidatesMissNothing) {
    Pair pair(twoSpheres());
    BodyState calm = pair.gpu.readState();
    for (std::size_t v = 0; v < calm.velocities.size(); ++v) {
        const bool lower = pair.model.pieceOfVertex[v] == 0;
        calm.positions[v].y() -= lower ? 0.12F : 0.0F;  // they do not touch until the end
        calm.velocities[v] = Vec3f(0, lower ? 0.4F : -0.4F, 0);
    }
    pair.gpu.setState(calm);
    pair.gpu.measure();
    shared::ContactUniforms close = pair.uniforms;
    close.reach = close.margin = 0.5F * close.h + close.thickness;
    close.interval = 0;
    const std::vector<double> masses(calm.positions.size(), 1);
    const ReferenceContact fresh(pair.model, close, masses);
    int compared = 0;
    int missed = 0;
    for (int step = 0; step < 12; ++step) {
        pair.gpu.step();
        pair.gpu.measure();
        const BodyState state = pair.gpu.readState();
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            pair.reference.positions[v] = state.positions[v].cast<double>();
        }
        const auto kept = pair.gpu.collisions().contacts().readCandidates();
        const auto wanted = fresh.findCandidates(pair.reference);
        for (std::size_t v = 0; v < kept.size(); ++v) {
            const bool full = kept[v].size() == shared::kCandidatesPerPoint;
            for (const ReferenceCandidate& candidate : wanted[v]) {
                const auto same = [&](const auto& c) { return c.triangle == candidate.triangle; };
                const bool counts = !full && clearlyOpposed(pair.model, v, candidate.triangle);
                compared += counts;
                missed += counts && std::ranges::none_of(kept[v], same);
            }
        }
    }
    EXPECT_EQ(missed, 0);
    EXPECT_GT(compared, 50);
    EXPECT_LT(pair.gpu.collisions().contacts().searches(), 10) << "in 12 steps";
}

// Displacements are 1e-4 m: a step of the fixed point is 5e-11 m.
TEST_F(ContactSolverTest, RespondsLikeTheReference) {
    for (const SurfaceMesh& mesh : {twoSpheres(), bentRound(), slitSphere()}) {
        SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices, seed " +
                     std::to_string(kContactSeed));
        Pair pair(mesh, 0, 0.00025);
        const ReferenceContact contact = pair.referenceContact();
        const auto candidates = contact.findCandidates(pair.reference);
        for (std::size_t v = 0; v < candidates.size(); ++v) {
            pair.reference.displacements[v] = pair.uniforms.substep * pair.reference.velocities[v];
        }
        const ReferenceState before = pair.reference;
        const int contacts = contact.respond(candidates, pair.reference);
        EXPECT_GT(contacts, 10);

        searchAnew(pair.gpu.collisions());
        shared::SolverUniforms uniforms = solverUniforms(pair.params);
        uniforms.active_parts = 0;
        pair.gpu.setUniforms(uniforms);
        pair.gpu.predictAndStretch();
        pair.gpu.collisions().respond();
        EXPECT_EQ(pair.gpu.collisions().contacts().readState().last_contacts,
                  static_cast<unsigned>(contacts));
        const std::vector<Vec3f> ours = pair.gpu.readDisplacements();
        const BodyState state = pair.gpu.readState();
        double change = 0;
        for (std::size_t v = 0; v < ours.size(); ++v) {
            EXPECT_LT((ours[v].cast<double>() - pair.reference.displacements[v]).norm(), 1e-8) << v;
            EXPECT_LT((state.positions[v].cast<double>() - pair.reference.positions[v]).norm(),
                      2e-7)
                << v;
            change = std::max(change,
                              (before.displacements[v] - pair.reference.displacements[v]).norm());
        }
        EXPECT_GT(change, 1e-5);
    }
}

/// Two beams on edge, crosswise, that fly into each other: their ridges meet half way between
/// vertices.
SurfaceMesh crossedBeams() {
    const auto onEdge = [](double turn) {
        TriangleSoup soup = boxSoup({1, 0.2, 0.2}, 4);
        const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(turn, Vec3::UnitY()) *
                                          Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()))
                                             .toRotationMatrix();
        for (Vec3& p : soup.positions) {
            p = rotation * p;
        }
        return soup;
    };
    const TriangleSoup lower = onEdge(0);
    SurfaceMesh mesh = meshOf(joined(lower, onEdge(std::numbers::pi / 2), {0.125, 0.48, 0.125}));
    for (int v = static_cast<int>(lower.positions.size()); v < mesh.vertexCount(); ++v) {
        mesh.setVelocity(v, {0, -1.5, 0});
    }
    return mesh;
}

TEST_F(ContactSolverTest, EdgesDoNotPassThroughEdges) {
    Simulation simulation(crossedBeams(), withoutWeight());
    int stepsInContact = 0;
    for (int i = 0; i < 75; ++i) {
        stepsInContact += simulation.step().contacts > 0;
        if (i % 3 == 0) {
            EXPECT_EQ(selfIntersections(simulation.mesh()).size(), 0U) << i;
        }
    }
    EXPECT_GT(stepsInContact, 3);
    EXPECT_LE(simulation.report().contacts, 5) << "they have parted, but for some vertices";
}

TEST_F(ContactSolverTest, KeepsMomentum) {
    const CollisionFigures figures = collideSpheres(withContact());
    EXPECT_GT(figures.stepsInContact, 5);
    EXPECT_TRUE(figures.parted);
    EXPECT_LT(figures.linearDrift, 3e-5);
    EXPECT_LT(figures.angularDrift, 1e-3);
}

TEST_F(ContactSolverTest, HalvesRestOnEachOther) {
    const HalvesFigures figures = restHalves(false, withContact(), 0.6);
    // A push needs a depth.
    EXPECT_LE(figures.penetration, 5e-5);
    EXPECT_GT(figures.contacts, 50);
    EXPECT_GT(figures.height, 0.95);
    EXPECT_LT(figures.shift, 0.1);
}

TEST_F(ContactSolverTest, NothingPassesThroughWhatItIsThrownAt) {
    RandomDropFigures sum;
    const std::uint64_t seed = 1;
    for (int i = 0; i < runs("KERF_FUZZ_RUNS", 1, 12); ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " drop " + std::to_string(i));
        sum.add(dropAtRandom({seed, i}, withContact()));
    }
    EXPECT_EQ(sum.nonFinite, 0) << text(sum);
    EXPECT_EQ(sum.escaped, 0) << text(sum);
    EXPECT_EQ(sum.tunnels, 0) << text(sum);
}

}  // namespace
}  // namespace kerf
