#include "sim/body/body_updater.h"

#include <bit>

#include "sim/body/surface_tag.h"

namespace kerf {
namespace {

/// Records by their vertices, as a set.
template <class Record>
std::map<std::array<std::uint32_t, sizeof(verticesOf(Record{})) / 4>, Record> byVertices(
    const std::vector<Record>& records) {
    std::map<std::array<std::uint32_t, sizeof(verticesOf(Record{})) / 4>, Record> out;
    for (const Record& record : records) {
        EXPECT_TRUE(out.emplace(verticesOf(record), record).second) << "a record twice";
    }
    return out;
}

template <class Record, class Same>
void expectSameSet(const std::vector<Record>& followed, const std::vector<Record>& fresh,
                   Same&& same) {
    const auto a = byVertices(followed);
    const auto b = byVertices(fresh);
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [vertices, record] : b) {
        const auto other = a.find(vertices);
        ASSERT_NE(other, a.end()) << "a record with vertex " << vertices[0] << " is missing";
        EXPECT_TRUE(same(other->second, record)) << vertices[0];
    }
}

/// Every element is in the lists of its vertices, in order, and nothing else is.
template <class Element>
void expectLists(const std::vector<Element>& elements, const Incidence& incidence) {
    std::size_t entries = 0;
    for (std::size_t v = 0; v < incidence.ranges.size(); ++v) {
        const IncidenceRange& range = incidence.ranges[v];
        for (std::uint32_t k = range.first; k < range.end; ++k) {
            const std::uint32_t entry = incidence.entries[k];
            ASSERT_LT(entry / 4, elements.size());
            EXPECT_EQ(verticesOf(elements[entry / 4])[entry % 4], v);
            EXPECT_TRUE(k == range.first || incidence.entries[k - 1] < entry);
        }
        entries += range.end - range.first;
    }
    EXPECT_EQ(entries, elements.size() * sizeof(verticesOf(Element{})) / 4);
}

void expectListsDoNotOverlap(const Incidence& incidence) {
    std::vector<char> taken(incidence.entries.size(), 0);
    for (const IncidenceRange& range : incidence.ranges) {
        for (std::uint32_t k = range.first; k < range.end; ++k) {
            ASSERT_EQ(std::exchange(taken[k], 1), 0);
        }
    }
}

void expectNeighbours(const BodyModel& model, const SurfaceMesh& mesh) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const IncidenceRange& range = model.neighbours.ranges[v];
        EXPECT_EQ(static_cast<int>(range.end - range.first), valence(mesh, v));
        for (std::uint32_t k = range.first; k < range.end; ++k) {
            const std::uint32_t entry = model.neighbours.entries[k];
            const auto next = k + 1 < range.end ? k + 1 : range.first;
            const int h = mesh.findHalfEdge(v, static_cast<int>(entry & ~shared::kAfterGap));
            ASSERT_GE(h, 0);
            EXPECT_EQ(mesh.apex(h),
                      static_cast<int>(model.neighbours.entries[next] & ~shared::kAfterGap));
            EXPECT_EQ((entry & shared::kAfterGap) != 0, mesh.absent(mesh.twin(h) / 3));
        }
    }
}

void expectMasses(const BodyModel& followed, const BodyModel& fresh) {
    const std::vector<double> a = unitMasses(followed);
    const std::vector<double> b = unitMasses(fresh);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t v = 0; v < a.size(); ++v) {
        EXPECT_NEAR(a[v], b[v], 1e-9 * followed.uncutRestVolume) << v;
    }
}

/// The rule for ISPCs: each stands on a living triangle of its piece, crosses no wall, and a vertex
/// has none only where none can be cast.
void expectIspcs(const BodyModel& model, const BodyModel& fresh, const SurfaceMesh& mesh) {
    std::vector<char> has(mesh.vertexCount(), 0);
    for (std::size_t i = 0; i < model.ispcs.size(); ++i) {
        const shared::IspcConstraint& ispc = model.ispcs[i];
        EXPECT_EQ(std::exchange(has[ispc.vertex], 1), 0) << "two for vertex " << ispc.vertex;
        const int t = model.ispcMeshTriangle[i];
        ASSERT_TRUE(mesh.alive(t));
        const Triangle end{static_cast<int>(ispc.t0), static_cast<int>(ispc.t1),
                           static_cast<int>(ispc.t2)};
        EXPECT_EQ(mesh.triangle(t), end);
        EXPECT_EQ(model.pieceOfVertex[ispc.vertex], model.pieceOfVertex[ispc.t0]);
    }
    std::size_t missing = 0;
    for (const shared::IspcConstraint& ispc : fresh.ispcs) {
        missing += has[ispc.vertex] == 0;
    }
    EXPECT_EQ(missing, 0u);
}

void expectFollowed(const BodyModel& model, const SurfaceMesh& mesh) {
    BodyModel fresh = buildBodyModel(mesh);
    ASSERT_EQ(model.pieces.size(), fresh.pieces.size());
    EXPECT_EQ(model.restPositions, fresh.restPositions);
    expectMasses(model, fresh);
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const Triangle& corners = mesh.triangle(model.meshTriangle[i]);
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(model.triangles[i][k], static_cast<std::uint32_t>(corners[k]));
        }
        EXPECT_EQ(model.triangles[i][3],
                  surfaceTag(mesh, model.meshTriangle[i]) |
                      static_cast<std::uint32_t>(model.pieceOfVertex[corners[0]]) << 8);
    }
    EXPECT_EQ(model.triangles.size(), fresh.triangles.size());
    expectIspcs(model, fresh, mesh);
    expectLists(model.triangles, model.triangleIncidence);
    expectListsDoNotOverlap(model.triangleIncidence);
    forEachType(model, [&](auto row, const auto& constraints) {
        expectLists(constraints, model.incidences[row.kType]);
        expectListsDoNotOverlap(model.incidences[row.kType]);
    });
    expectNeighbours(model, mesh);
}

template <class T>
std::array<std::byte, sizeof(T)> bitsOf(const T& value) {
    return std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
}

/// A change names everything that differs; what is new and zero need not be named.
template <class T>
void expectNamed(const std::vector<T>& before, const std::vector<T>& after,
                 const std::vector<std::uint32_t>& named, const char* what) {
    for (std::size_t i = 0; i < after.size(); ++i) {
        const T zero{};
        const T& old = i < before.size() ? before[i] : zero;
        const bool same = bitsOf(old) == bitsOf(after[i]);
        EXPECT_TRUE(same ||
                    std::binary_search(named.begin(), named.end(), static_cast<std::uint32_t>(i)))
            << what << " " << i;
    }
}

struct Follower {
    std::size_t moved = 0;  ///< vertices, by the clean-up
    std::size_t died = 0;
    SurfaceMesh mesh;
    BodyUpdater updater{mesh};

    explicit Follower(SurfaceMesh whole) : mesh(std::move(whole)) {}

    void apply(const CutResult& result) {
        if (result.delta.empty()) {
            return;
        }
        moved += result.delta.movedVertices.size();
        died += result.delta.deadVertices.size();
        const BodyModel before = updater.model();
        const BodyChange change = updater.update(result.delta);
        const BodyModel& after = updater.model();
        expectFollowed(after, mesh);
        expectNamed(before.triangles, after.triangles, change.triangles.slots, "triangle");
        expectNamed(before.edges, after.edges, change.constraints[shared::kStretch].slots, "edge");
        expectNamed(before.bends, after.bends, change.constraints[shared::kBend].slots, "bend");
        expectNamed(before.ispcs, after.ispcs, change.constraints[shared::kIspc].slots, "ISPC");
        expectNamed(before.vertexAreas, after.vertexAreas, change.vertices, "area");
        expectNamed(before.pieceOfVertex, after.pieceOfVertex, change.vertices, "piece");
        for (std::uint32_t type = 0; type < kConstraintTypes; ++type) {
            expectNamed(before.incidences[type].ranges, after.incidences[type].ranges,
                        change.constraints[type].vertices, "list of constraints");
        }
        expectNamed(before.triangleIncidence.ranges, after.triangleIncidence.ranges,
                    change.triangles.vertices, "list of triangles");
    }

    void cut(const Stroke& stroke) {
        Cutter cutter(mesh, exactSettings());
        eachStep(cutter, stroke, [&](const CutResult& result) { apply(result); });
    }
};

TEST(BodyUpdater, FollowsRandomCutsAsASetBuiltAnew) {
    const unsigned seed = 21;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto direction = [&] {
        return Vec3(uniform(random), uniform(random), uniform(random)).normalized();
    };
    for (const SurfaceMesh& shape : {torus(24, 12), icosphere(2)}) {
        Follower follower(shape);
        for (int stroke = 0; stroke < 4; ++stroke) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", stroke " + std::to_string(stroke));
            const Vec3 along = direction();
            const Vec3 travel = along.cross(direction()).normalized();
            follower.cut(straightStroke(0.1 * direction(), along, travel, 3, 2, 15));
        }
        EXPECT_GT(follower.updater.model().pieces.size(), 2u);
        EXPECT_GT(follower.moved, 0u);
        EXPECT_GT(follower.died, 0u);
        const BodyModel fresh = buildBodyModel(follower.mesh);
        // The thickness is that of the uncut body; a model made anew takes that of the cut one.
        const double thicker =
            follower.updater.model().members[0].thickness / fresh.members[0].thickness;
        const auto sameEdge = [&](const auto& a, const auto& b) {
            return a.rest_length == b.rest_length &&
                   std::abs(a.geometry * thicker - b.geometry) <= 1e-5 * b.geometry;
        };
        const auto sameBend = [&](const auto& a, const auto& b) {
            return a.rest_angle == b.rest_angle &&
                   std::abs(a.geometry * std::pow(thicker, 3) - b.geometry) <= 1e-5 * b.geometry;
        };
        expectSameSet(follower.updater.model().edges, fresh.edges, sameEdge);
        expectSameSet(follower.updater.model().bends, fresh.bends, sameBend);
    }
}

TEST(BodyUpdater, CopiesInPortions) {
    const SurfaceMesh mesh = box(Vec3::Ones(), 8);
    const BodyUpdater body(mesh);
    int rests = 0;
    const Pauses pauses([&] { ++rests; });
    const auto copy = std::make_unique<BodyUpdater>(body);
    EXPECT_EQ(rests, 3);
    EXPECT_EQ(copy->model().triangles, body.model().triangles);
}

// The copies of a point have one look, and a tear leaves the end of a cut as it was.
TEST(SurfaceTag, SaysWhichCornersAreTorn) {
    SurfaceMesh mesh = cubeSphere(2, 0.5);
    const auto copyOf = [&](int v) {
        const int copy = mesh.addVertex(mesh.position(v), mesh.restPosition(v), mesh.velocity(v));
        mesh.joinCopies(v, copy);
        return copy;
    };
    const std::uint32_t before = surfaceTag(mesh, 0);
    const int ofCut = copyOf(0);
    const int ofTear = mesh.addVertex(Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
    mesh.noteTorn(ofCut);
    const int later = copyOf(ofTear);
    mesh.noteTorn(later);
    EXPECT_FALSE(mesh.isTorn(0));
    EXPECT_FALSE(mesh.isTorn(ofCut));
    EXPECT_TRUE(mesh.isTorn(ofTear));
    EXPECT_TRUE(mesh.isTorn(later));
    EXPECT_FALSE(mesh.isTorn(copyOf(0))) << "of a blade, later";
    mesh.setCorner(0, 1, later);
    EXPECT_EQ(surfaceTag(mesh, 0), before | 1U << 5);
}

}  // namespace
}  // namespace kerf
