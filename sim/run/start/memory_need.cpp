#include "sim/run/start/memory_need.h"

#include "shaders/shared/body_records.h"
#include "shaders/shared/box_records.h"
#include "shaders/shared/contact_records.h"
#include "shaders/shared/implicit_records.h"
#include "shaders/shared/unfold_records.h"
#include "sim/body/constraint_lists.h"
#include "sim/body/ispc_builder.h"
#include "sim/body/solver_uniforms.h"
#include "sim/mesh/box_tree.h"
#include "sim/solve/implicit/step_choice.h"
#include "sim/solve/implicit/vertex_groups.h"

namespace kerf {

namespace {

/// An amount per vertex and per triangle of a mesh.
struct PerElement {
    double vertex = 0;
    double triangle = 0;

    friend constexpr PerElement operator+(const PerElement& a, const PerElement& b) {
        return {a.vertex + b.vertex, a.triangle + b.triangle};
    }
    friend constexpr PerElement operator*(double times, const PerElement& each) {
        return {times * each.vertex, times * each.triangle};
    }
    /// The total for a mesh.
    constexpr double of(double vertices, double triangles) const {
        return vertex * vertices + triangle * triangles;
    }
};

/// How many edges a closed surface has.
inline constexpr PerElement kEdges{0, 1.5};

using shared::uint;
using shared::vec4;

// A cut through the middle of a ball adds half of its triangles as walls, and divides skin: 1.59 to
// 1.71 times as many, from 10,000 triangles to a million.
constexpr double kGrowthByCut = 1.75;
// As measured, on llvmpipe: program, kernels, pictures and the interface with a small model; and
// what is taken for each byte of records, by lists in the making, copies on their way, and by what
// the heap keeps of what was freed.
constexpr std::uint64_t kProgram = 200'000'000;
constexpr double kOverRecords = 1.6;

// While inverses are made they lie there as matrix, pivots, inverse in doubles, and texels.
constexpr double kInMaking = 5;
constexpr double kOfKernels = 400'000;  // those of implicit steps, for numbers of dispatches

constexpr double kWord = sizeof(std::uint32_t);

/// How many entries an Incidence has of `elements` with so many vertices each, with the room that
/// lists have to spare: two entries, as where six triangles meet.
PerElement entriesOf(const PerElement& elements, int verticesOfEach) {
    return verticesOfEach * elements + PerElement{2, 0};
}

/// The lists of all that touches a vertex, with so many ISPCs for each.
struct Entries {
    explicit Entries(int ispcsOfEach) : ispcs(entriesOf({1.0 * ispcsOfEach, 0}, 4)) {}

    PerElement triangles = entriesOf({0, 1}, 3);  // and as many neighbours
    PerElement edges = entriesOf(kEdges, 2);
    PerElement bends = entriesOf(kEdges, 4);
    PerElement ispcs;
};
constexpr double kLists = 2 + kConstraintTypes;  // of triangles, of neighbours, of constraints

PerElement bytesOfMesh() {
    return {3 * sizeof(Vec3) + 2 * sizeof(int) + 1, sizeof(Triangle) + 4 * sizeof(int) + 1};
}

/// A tree that is divided everywhere: leaves of eight are about half full, and there is an inner
/// node for each.
PerElement bytesOfTree() {
    constexpr double kThing = 4 * sizeof(float) + 2 * sizeof(int);
    constexpr double kNodes = 2.0 / 4;
    return {0, kThing + kNodes * sizeof(BoxTree::Node)};
}

/// What a triangle counts for, and its share of volume and area.
PerElement bytesOfLabels() {
    return {2 * sizeof(int), sizeof(Triangle) + 2 * sizeof(int) + 2 * sizeof(double)};
}

/// Lists by vertex and triangle, and a grid of 32 cells each way, of which each ray passes twice as
/// many.
PerElement bytesOfIspcs(int ispcsOfEach) {
    constexpr double kCells = 64;
    return PerElement{ispcsOfEach * (sizeof(shared::IspcConstraint) + (4 + kCells) * sizeof(int)),
                      sizeof(int)} +
           bytesOfTree();
}

PerElement bytesOfModel(int ispcsOfEach) {
    const Entries entries(ispcsOfEach);
    const PerElement all = 2 * entries.triangles + entries.edges + entries.bends + entries.ispcs;
    const PerElement vertices{2 * sizeof(Vec3f) + sizeof(double) + sizeof(int) + sizeof(Vec3) +
                                  kLists * (sizeof(IncidenceRange) + kWord),
                              0};
    // Beside each edge and bend stand their half-edges, and the way back.
    const double perEdge = sizeof(EdgeConstraint) + sizeof(BendConstraint) + 8 * sizeof(int);
    return vertices + PerElement{0, 4 * kWord + 2 * sizeof(int)} + perEdge * kEdges + kWord * all;
}

/// A copy of a body, as a snapshot has one: the mesh, the updater, the cutter.
PerElement bytesOfCopy(int ispcsOfEach) {
    const PerElement cutter =
        bytesOfLabels() + bytesOfTree() + PerElement{sizeof(int), sizeof(Triangle) + sizeof(int)};
    return bytesOfMesh() + bytesOfModel(ispcsOfEach) + bytesOfLabels() + bytesOfIspcs(ispcsOfEach) +
           cutter;
}

/// The blocks beside the diagonal in the matrix of an implicit stage: of ends of edges, tips of
/// bends, and an ISPC with the corners of its triangle.
PerElement implicitBlocks(int ispcsOfEach) {
    return 4 * kEdges + PerElement{6.0 * ispcsOfEach, 0};
}

/// What shaders write to in implicit steps: blocks and factors of MatrixBuffers, ContactBuffers,
/// StageVectors.
std::vector<PerElement> writtenInImplicitSteps(int ispcsOfEach) {
    constexpr double kRows = shared::kRowsOfVertex;
    const PerElement factors =
        2 * Entries(ispcsOfEach).edges + 4 * kEdges + PerElement{4.0 * ispcsOfEach, 0};
    return {3 * sizeof(vec4) * implicitBlocks(ispcsOfEach),
            sizeof(vec4) * factors,
            sizeof(vec4) / 8.0 * factors,  // their pulls
            {kRows * sizeof(shared::ContactRow), 0},
            {kRows * (sizeof(shared::RowState) + 3 * sizeof(vec4)), 0},  // what else rows have
            {15 * sizeof(vec4) + (kRows + 2) * kWord, 0}};               // vectors, list of rows
}

/// Of implicit steps: the lists of MatrixBuffers, and InverseBuffers without inverses.
PerElement readInImplicitSteps(int ispcsOfEach) {
    constexpr double kOfGroups = 40;  // bytes of patches and aggregates, on each vertex
    // Pairs of vertices of edges, of bends, of ISPCs.
    const PerElement shares = (4.0 + 16.0) * kEdges + PerElement{16.0 * ispcsOfEach, 0};
    return sizeof(shared::ImplicitBlock) * implicitBlocks(ispcsOfEach) +
           kWord * (shares + Entries(ispcsOfEach).edges) +
           PerElement{6 * kWord + sizeof(shared::ImplicitMember) + sizeof(vec4) + kOfGroups, 0};
}

/// The inverses of patches, aggregates and regions of a body in one piece, whose boxes are halved
/// until they are small enough: where not all have the same number of vertices, some once more.
double bytesOfInverses(double vertices) {
    constexpr double kUneven = 1.1;
    constexpr double kCoarse = 3 * shared::kAggregateModes * sizeof(vec4);
    const auto count = static_cast<std::size_t>(vertices);
    const double boxes = kUneven * vertices / double(ImplicitStep::of({}, count, 1).aggregateSize);
    const double aggregates = kUneven * std::exp2(std::ceil(std::log2(std::max(1.0, boxes))));
    const bool hasRegions = aggregates > kMostAggregates;
    const double together = hasRegions ? 2.0 * kRegions : aggregates;
    const double alone = hasRegions ? aggregates : 0;
    return 3 * sizeof(vec4) * kPatchSize * vertices + kCoarse * (together * together + alone);
}

/// The buffers of the running body that shaders write to; the lists that they only read come as
/// texels, which drivers allow to be larger.
std::vector<PerElement> writtenBuffers(const MemorySettings& settings) {
    std::vector<PerElement> buffers(6, {sizeof(vec4), 0});  // X, v, d, and those that were before
    buffers.push_back(2 * sizeof(vec4) * kEdges);           // the pulls of bends
    buffers.push_back({sizeof(shared::UnfoldGoal), 0});
    buffers.push_back({sizeof(float), 0});  // folds
    if (settings.contact) {
        buffers.push_back({4 * sizeof(vec4), 0});  // normals, and what was searched from
        buffers.push_back({shared::kCandidatesPerPoint * sizeof(shared::ContactCandidate), 0});
        buffers.push_back({shared::kEdgePairsPerPoint * sizeof(shared::EdgePair), 0});
        buffers.push_back({2 * sizeof(shared::ContactRecord), 0});
        buffers.push_back({11 * sizeof(uint), 0});                // points, shares and sums
        buffers.push_back({0, 2 * sizeof(vec4)});                 // boxes of triangles
        buffers.push_back({0, 0.6 * sizeof(vec4)});               // and of nodes
        buffers.push_back({2 * sizeof(uint), 2 * sizeof(uint)});  // their order
        buffers.push_back(
            {2.0 * sizeof(uint) * shared::kMostGroupLeaves / shared::kSearchGroup, 0});
    }
    if (settings.obstacles) {
        buffers.push_back({0, sizeof(shared::BoxTouch)});
        buffers.push_back({7 * sizeof(uint) + 2 * sizeof(vec4), 0});
    }
    if (settings.implicit) {
        std::ranges::copy(writtenInImplicitSteps(settings.ispcsPerVertex),
                          std::back_inserter(buffers));
    }
    buffers.push_back({2 * sizeof(vec4), 0});                 // normals for pictures
    buffers.push_back({2 * sizeof(uint), 3 * sizeof(uint)});  // corners of the skin
    return buffers;
}

/// The rest shape, its constraints and what they touch.
PerElement readBuffers(int ispcsOfEach) {
    const Entries entries(ispcsOfEach);
    const PerElement vertices{
        3 * sizeof(vec4) + sizeof(float) + (kLists - 1) * sizeof(shared::IncidenceRange) +
            sizeof(shared::BendRange) + ispcsOfEach * sizeof(shared::IspcConstraint) + 3 * kWord,
        0};
    return vertices + PerElement{0, 4 * kWord} + sizeof(shared::BendRecord) * kEdges +
           2 * kWord * entries.triangles + sizeof(shared::Spoke) * entries.edges +
           kWord * entries.bends + sizeof(shared::ConstraintShare) * entries.ispcs;
}

std::uint64_t bytes(double count) {
    return static_cast<std::uint64_t>(count);
}

}  // namespace

MemorySettings memorySettings(const Params& params, bool hasBoxes) {
    MemorySettings settings;
    settings.contact = params.contact != 0;
    settings.ispcsPerVertex = raysPerVertex(ispcRays(params));
    settings.obstacles = hasBoxes || params.bladePush != 0;
    settings.implicit = params.solver == SolverMode::implicit;
    return settings;
}

/// The uncut body and the one that runs, and the mesh that they were made from.
std::uint64_t bytesPrepared(const BodySize& size, int ispcsPerVertex) {
    const PerElement all = 2 * bytesOfCopy(ispcsPerVertex) + bytesOfMesh();
    return bytes(all.of(size.vertices, size.triangles));
}

std::uint64_t bytesOfSnapshot(const BodySize& size, int ispcsPerVertex) {
    return bytes(bytesOfCopy(ispcsPerVertex).of(size.vertices, size.triangles));
}

std::uint64_t bytesOnGpu(const BodySize& size, const MemorySettings& settings) {
    double all = readBuffers(settings.ispcsPerVertex).of(size.vertices, size.triangles);
    for (const PerElement& buffer : writtenBuffers(settings)) {
        all += buffer.of(size.vertices, size.triangles);
    }
    if (settings.implicit) {
        all += readInImplicitSteps(settings.ispcsPerVertex).of(size.vertices, size.triangles) +
               bytesOfInverses(size.vertices) + kOfKernels;
    }
    return bytes(all);
}

MemoryNeed memoryNeedOf(const BodySize& size, const MemorySettings& settings) {
    const double copy = bytesOfCopy(settings.ispcsPerVertex).of(size.vertices, size.triangles);
    // What was before a change and what was after it, where the budget lets a copy be kept at all;
    // the start of the course, and another checkpoint.
    const double undoBudget = static_cast<double>(settings.undoBudget);
    const double undo = copy <= undoBudget ? std::min(undoBudget, (1 + kGrowthByCut) * copy) : 0;
    const double checkpointBudget = static_cast<double>(settings.checkpointBudget);
    const double course = checkpointBudget > 0 ? copy + std::min(checkpointBudget, copy) : 0;
    const BodySize cut{kGrowthByCut * size.vertices, kGrowthByCut * size.triangles};
    MemoryNeed need;
    need.program = kProgram;
    need.memory =
        bytes(kOverRecords * (static_cast<double>(bytesPrepared(size, settings.ispcsPerVertex)) +
                              (kGrowthByCut - 1) * copy + undo + course));
    if (settings.implicit) {
        need.memory += bytes(kInMaking * bytesOfInverses(cut.vertices));
    }
    need.graphics = bytes(kOverRecords * static_cast<double>(bytesOnGpu(cut, settings)));
    for (const PerElement& buffer : writtenBuffers(settings)) {
        need.largestBuffer =
            std::max(need.largestBuffer, bytes(buffer.of(cut.vertices, cut.triangles)));
    }
    return need;
}

}  // namespace kerf
