#include "sim/body/ispc_builder.h"
#include "tests/sim/body/ispc_bits.h"

namespace kerf {
namespace {

RayTree wallTree(const SurfaceMesh& mesh) {
    std::vector<int> walls;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t) && mesh.kind(t) == SurfaceKind::wall) {
            walls.push_back(t);
        }
    }
    return RayTree(mesh, walls);
}

/// ISPCs that a wall separates; their own ends, which may lie on walls, do not count.
int separatedIspcs(const SurfaceMesh& mesh, const BodyModel& model) {
    const RayTree walls = wallTree(mesh);
    int separated = 0;
    for (const auto& ispc : model.ispcs) {
        const Vec3& start = mesh.restPosition(static_cast<int>(ispc.vertex));
        const Vec3 inner = 1e-3 * (restEnd(mesh, ispc) - start);
        separated += walls.crosses(start + inner, restEnd(mesh, ispc) - inner);
    }
    return separated;
}

int sharedIspcs(const BodyModel& a, const BodyModel& b) {
    std::map<std::uint32_t, shared::IspcConstraint> ofVertex;
    for (const auto& ispc : b.ispcs) {
        ofVertex[ispc.vertex] = ispc;
    }
    int shared = 0;
    for (const auto& ispc : a.ispcs) {
        const auto other = ofVertex.find(ispc.vertex);
        shared += other != ofVertex.end() && sameBits(ispc, other->second);
    }
    return shared;
}

/// A body that is cut step by step, with its model carried along.
struct CutBody {
    SurfaceMesh mesh;
    BodyUpdater updater{mesh};
    const BodyModel& model = updater.model();
    int changes = 0;

    explicit CutBody(SurfaceMesh whole) : mesh(std::move(whole)) {}

    template <class Check>
    void run(const Stroke& stroke, Check&& check) {
        Cutter cutter(mesh, exactSettings());
        eachStep(cutter, stroke, [&](const CutResult& result) {
            if (!result.delta.empty()) {
                const BodyModel before = model;
                updater.update(result.delta);
                ++changes;
                check(before);
            }
        });
    }
};

Stroke strokeDown(int steps) {
    return straightStroke(Vec3(0.013, 0.021, 0.034), Vec3(1, 0.05, 0.1).normalized(),
                          -Vec3::UnitY(), 3.0, 2.4, steps);
}

TEST(BodyCut, TheModelFollowsTheCutStepByStep) {
    CutBody body(icosphere(3));
    const double mass = body.model.uncutRestVolume;
    body.run(strokeDown(40), [&](const BodyModel& before) {
        const std::vector<double> masses = unitMasses(body.model);
        const double sum = std::accumulate(masses.begin(), masses.end(), 0.0);
        EXPECT_NEAR(sum, mass, 1e-5 * mass);
        EXPECT_EQ(separatedIspcs(body.mesh, body.model), 0) << "after change " << body.changes;
        // A step touches a band of the body; the rest keeps its ISPCs.
        EXPECT_GT(sharedIspcs(before, body.model), before.ispcs.size() / 2);
        EXPECT_EQ(2 * body.model.edges.size(), 3 * body.model.triangles.size());
    });
    EXPECT_GT(body.changes, 5);
    ASSERT_EQ(body.model.pieces.size(), 2u);
    int used = 0;
    for (const int piece : body.model.pieceOfVertex) {
        used += piece >= 0;
    }
    EXPECT_GT(body.model.ispcs.size(), 0.98 * used);
}

/// Along a stroke that goes right through the middle of an ISPC.
Stroke strokeAcross(const SurfaceMesh& mesh, const shared::IspcConstraint& ispc) {
    const Vec3& start = mesh.restPosition(static_cast<int>(ispc.vertex));
    const Vec3 end = restEnd(mesh, ispc);
    const Vec3 along = (end - start).unitOrthogonal();
    const Vec3 travel = (end - start).cross(along).normalized();
    return straightStroke(0.5 * (start + end), along, travel, 3.0, 2.4, 30);
}

TEST(BodyCut, NoneOfTheIspcsIsForgotten) {
    const SurfaceMesh whole = icosphere(2);
    for (const std::size_t slot : {0U, 1U, 77U}) {
        CutBody body(whole);
        body.run(strokeAcross(whole, body.model.ispcs[slot]), [&](const BodyModel&) {
            EXPECT_EQ(separatedIspcs(body.mesh, body.model), 0) << "after change " << body.changes;
        });
        EXPECT_EQ(body.model.pieces.size(), 2u);
    }
}

}  // namespace
}  // namespace kerf
