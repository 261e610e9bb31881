#include "sim/solve/gpu_solver.h"

#include <algorithm>
#include <cassert>

#include "shaders/shared/bindings.h"
#include "sim/body/incidence.h"
#include "sim/solve/solver_uniforms.h"

namespace kerf {

namespace {

using shared::uint;

static_assert(sizeof(shared::SolverUniforms) == 96);
static_assert(sizeof(shared::EdgeConstraint) == 16);
static_assert(sizeof(shared::BendConstraint) == 24);
static_assert(sizeof(shared::IspcConstraint) == 32);
static_assert(sizeof(shared::VertexLinks) == 16);
static_assert(sizeof(shared::PieceRecord) == 20);
static_assert(sizeof(shared::BlockRecord) == 12);
static_assert(sizeof(shared::VolumeSum) == 8);
static_assert(sizeof(shared::BlockMeasure) == 32);

// Every vertex adds up the blocks of its piece, so there are few of them however large it is.
constexpr uint kMaxBlocksPerPiece = 32;

uint size32(std::size_t size) {
    return static_cast<uint>(size);
}

shared::vec4 packed(const Vec3f& a, float w) {
    return {a.x(), a.y(), a.z(), w};
}

std::vector<shared::vec4> packed(const std::vector<Vec3f>& values) {
    std::vector<shared::vec4> out(values.size());
    std::transform(values.begin(), values.end(), out.begin(),
                   [](const Vec3f& a) { return packed(a, 0.0f); });
    return out;
}

std::vector<Vec3f> unpacked(const gpu::Buffer& buffer, std::size_t count) {
    const std::vector<shared::vec4> values = buffer.read<shared::vec4>(0, count);
    std::vector<Vec3f> out(count);
    std::transform(values.begin(), values.end(), out.begin(),
                   [](const shared::vec4& a) { return Vec3f(a.x, a.y, a.z); });
    return out;
}

std::vector<float> inverses(const std::vector<float>& masses) {
    std::vector<float> out(masses.size());
    std::transform(masses.begin(), masses.end(), out.begin(),
                   [](float m) { return m > 0.0f ? 1.0f / m : 0.0f; });
    return out;
}

std::vector<shared::VertexLinks> vertexLinks(const BodyModel& model) {
    std::vector<shared::VertexLinks> links(model.restPositions.size());
    for (std::size_t v = 0; v < links.size(); ++v) {
        const int piece = model.pieceOfVertex[v];
        links[v] = {valence(model.edgeIncidence, v), valence(model.bendIncidence, v),
                    valence(model.ispcIncidence, v),
                    piece < 0 ? shared::kNoPiece : static_cast<uint>(piece)};
    }
    return links;
}

struct Spoke {
    uint following;
    uint preceding;
};

/// Puts the triangles around a vertex in counter-clockwise order.
void sortUmbrella(std::span<Spoke> spokes) {
    for (std::size_t i = 1; i < spokes.size(); ++i) {
        const auto next = std::find_if(spokes.begin() + i, spokes.end(), [&](const Spoke& spoke) {
            return spoke.following == spokes[i - 1].preceding;
        });
        assert(next != spokes.end() && "each vertex has one umbrella");
        std::iter_swap(spokes.begin() + i, next);
    }
}

/// The vertices around each vertex, counter-clockwise; offsets are those of the triangle incidence.
std::vector<uint> neighbours(const BodyModel& model) {
    const Incidence& incidence = model.triangleIncidence;
    std::vector<uint> out;
    out.reserve(incidence.entries.size());
    std::vector<Spoke> spokes;
    for (std::size_t v = 0; v + 1 < incidence.offsets.size(); ++v) {
        spokes.clear();
        for (uint k = incidence.offsets[v]; k < incidence.offsets[v + 1]; ++k) {
            const auto& corners = model.triangles[incidence.entries[k] / 4];
            const uint slot = incidence.entries[k] % 4;
            spokes.push_back({corners[(slot + 1) % 3], corners[(slot + 2) % 3]});
        }
        sortUmbrella(spokes);
        for (const Spoke& spoke : spokes) {
            out.push_back(spoke.following);
        }
    }
    return out;
}

/// The used vertices, piece after piece, inside a piece by index.
std::vector<uint> verticesByPiece(const BodyModel& model) {
    std::vector<uint> next(1, 0);
    for (const PieceModel& piece : model.pieces) {
        next.push_back(next.back() + piece.vertexCount);
    }
    std::vector<uint> out(next.back());
    for (uint v = 0; v < model.pieceOfVertex.size(); ++v) {
        if (const int piece = model.pieceOfVertex[v]; piece >= 0) {
            out[next[piece]++] = v;
        }
    }
    return out;
}

uint blockSize(uint vertexCount) {
    const uint most = shared::kGroupSize * kMaxBlocksPerPiece;
    return shared::kGroupSize * std::max((vertexCount + most - 1) / most, 1u);
}

void appendBlocks(std::vector<shared::BlockRecord>& blocks, uint piece, uint firstPlace,
                  uint vertexCount) {
    const uint size = blockSize(vertexCount);
    for (uint done = 0; done < vertexCount; done += size) {
        blocks.push_back({piece, firstPlace + done, std::min(size, vertexCount - done)});
    }
}

}  // namespace

void GpuSolver::IncidenceBuffers::assign(const Incidence& incidence) {
    offsets.assign(incidence.offsets);
    entries.assign(incidence.entries);
}

void GpuSolver::IncidenceBuffers::bind() const {
    offsets.bindStorage(shared::kOffsetsBinding);
    entries.bindStorage(shared::kEntriesBinding);
}

GpuSolver::GpuSolver() {
    kernels_.stretch = gpu::Program::compute("sim/stretch.comp");
    kernels_.bend = gpu::Program::compute("sim/bend.comp");
    kernels_.ispc = gpu::Program::compute("sim/ispc.comp");
    kernels_.gatherCorrections = gpu::Program::compute("sim/gather_corrections.comp");
    kernels_.volumeGradient = gpu::Program::compute("sim/volume_gradient.comp");
    kernels_.volumeCorrect = gpu::Program::compute("sim/volume_correct.comp");
    kernels_.floor = gpu::Program::compute("sim/floor.comp");
    kernels_.finish = gpu::Program::compute("sim/finish.comp");
    kernels_.measure = gpu::Program::compute("sim/measure.comp");
}

void GpuSolver::setModel(const BodyModel& model, const BodyState& state) {
    inverseUnitMass_ = inverses(model.unitMass);
    uploadTopology(model);
    uploadPieces(model);
    setState(state);
    setCounts(uniforms_, model);
    uploadUniforms();
}

void GpuSolver::uploadTopology(const BodyModel& model) {
    const std::size_t vertexBytes = model.restPositions.size() * sizeof(shared::vec4);
    displacement_.resize(vertexBytes);
    displacement_.clear();
    gradients_.resize(vertexBytes);
    restPositions_.assign(packed(model.restPositions));
    links_.assign(vertexLinks(model));
    triangles_.assign(model.triangles);
    edges_.assign(model.edges);
    bends_.assign(model.bends);
    ispcs_.assign(model.ispcs);
    corrections_.resize(4 * sizeof(shared::vec4) *
                        std::max({model.bends.size(), model.ispcs.size(), std::size_t{1}}));
    edgeIncidence_.assign(model.edgeIncidence);
    bendIncidence_.assign(model.bendIncidence);
    ispcIncidence_.assign(model.ispcIncidence);
    triangleIncidence_.assign(model.triangleIncidence);
    neighbours_.assign(neighbours(model));
}

void GpuSolver::uploadPieces(const BodyModel& model) {
    const std::vector<uint> order = verticesByPiece(model);
    pieces_.clear();
    blocks_.clear();
    uint firstPlace = 0;
    for (const PieceModel& piece : model.pieces) {
        const uint firstBlock = size32(blocks_.size());
        appendBlocks(blocks_, size32(pieces_.size()), firstPlace, piece.vertexCount);
        pieces_.push_back({order[firstPlace], firstBlock, size32(blocks_.size()) - firstBlock,
                           piece.holdsVolume ? 1u : 0u, static_cast<float>(piece.restVolume)});
        firstPlace += piece.vertexCount;
    }
    vertexOrder_.assign(order);
    pieceBuffer_.assign(pieces_);
    blockBuffer_.assign(blocks_);
    blockSums_.resize(std::max<std::size_t>(blocks_.size(), 1) * sizeof(shared::VolumeSum));
    blockMeasures_.resize(std::max<std::size_t>(blocks_.size(), 1) * sizeof(shared::BlockMeasure));
}

void GpuSolver::setState(const BodyState& state) {
    assert(state.positions.size() == inverseUnitMass_.size());
    assert(state.velocities.size() == inverseUnitMass_.size());
    std::vector<shared::vec4> positions(state.positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        positions[v] = packed(state.positions[v], inverseUnitMass_[v]);
    }
    positions_.assign(positions);
    velocities_.assign(packed(state.velocities));
}

void GpuSolver::setUniforms(const shared::SolverUniforms& uniforms) {
    const shared::SolverUniforms counts = uniforms_;
    uniforms_ = uniforms;
    uniforms_.vertex_count = counts.vertex_count;
    uniforms_.edge_count = counts.edge_count;
    uniforms_.bend_count = counts.bend_count;
    uniforms_.ispc_count = counts.ispc_count;
    uniforms_.triangle_count = counts.triangle_count;
    uniforms_.piece_count = counts.piece_count;
    uploadUniforms();
}

void GpuSolver::uploadUniforms() {
    uniformBuffer_.assign(std::span<const shared::SolverUniforms>(&uniforms_, 1));
}

void GpuSolver::setVolumeTargets(std::span<const VolumeTarget> targets) {
    assert(targets.size() == pieces_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
        pieces_[p].target_volume = static_cast<float>(targets[p].volume);
        pieces_[p].constrained = targets[p].constrained ? 1 : 0;
    }
    pieceBuffer_.assign(pieces_);
}

void GpuSolver::anchor(int vertex, const Vec3f& velocity) {
    setInverseUnitMass(vertex, 0.0f);
    const shared::vec4 value = packed(velocity, 0.0f);
    velocities_.write(vertex, std::span<const shared::vec4>(&value, 1));
}

void GpuSolver::release(int vertex) {
    setInverseUnitMass(vertex, inverseUnitMass_[vertex]);
}

void GpuSolver::setInverseUnitMass(int vertex, float value) {
    const std::size_t w = 4 * static_cast<std::size_t>(vertex) + 3;
    positions_.write(w, std::span<const float>(&value, 1));
}

void GpuSolver::step() {
    for (uint i = 0; i < uniforms_.substeps; ++i) {
        deformTimer_.begin();
        predictAndStretch();
        solveBends();
        solveIspcs();
        solveVolume();
        deformTimer_.end();
        collideTimer_.begin();
        collideFloor();
        collideTimer_.end();
        deformTimer_.begin();
        finishSubstep();
        deformTimer_.end();
    }
}

void GpuSolver::predictAndStretch() {
    bindBody();
    edges_.bindStorage(shared::kConstraintsBinding);
    edgeIncidence_.bind();
    run(kernels_.stretch, uniforms_.vertex_count);
}

void GpuSolver::solveBends() {
    if (active(shared::kBendPart)) {
        runOverConstraints(kernels_.bend, bends_, uniforms_.bend_count, bendIncidence_);
    }
}

void GpuSolver::solveIspcs() {
    if (active(shared::kIspcPart)) {
        runOverConstraints(kernels_.ispc, ispcs_, uniforms_.ispc_count, ispcIncidence_);
    }
}

void GpuSolver::runOverConstraints(const gpu::Program& kernel, const gpu::Buffer& records,
                                   uint count, const IncidenceBuffers& incidence) {
    bindBody();
    records.bindStorage(shared::kConstraintsBinding);
    corrections_.bindStorage(shared::kCorrectionsBinding);
    incidence.bind();
    run(kernel, count);
    run(kernels_.gatherCorrections, uniforms_.vertex_count);
}

void GpuSolver::solveVolume() {
    bindBody();
    blockSums_.bindStorage(shared::kBlockSumsBinding);
    runOverBlocks(kernels_.volumeGradient);
    run(kernels_.volumeCorrect, uniforms_.vertex_count);
}

void GpuSolver::runOverBlocks(const gpu::Program& kernel) {
    triangleIncidence_.offsets.bindStorage(shared::kOffsetsBinding);
    neighbours_.bindStorage(shared::kEntriesBinding);
    vertexOrder_.bindStorage(shared::kVertexOrderBinding);
    run(kernel, size32(blocks_.size()) * shared::kGroupSize);
}

void GpuSolver::collideFloor() {
    if (active(shared::kFloorPart)) {
        bindBody();
        run(kernels_.floor, uniforms_.vertex_count);
    }
}

void GpuSolver::finishSubstep() {
    bindBody();
    run(kernels_.finish, uniforms_.vertex_count);
}

void GpuSolver::bindBody() const {
    uniformBuffer_.bindStorage(shared::kUniformsBinding);
    positions_.bindStorage(shared::kPositionsBinding);
    velocities_.bindStorage(shared::kVelocitiesBinding);
    displacement_.bindStorage(shared::kDisplacementBinding);
    links_.bindStorage(shared::kLinksBinding);
    gradients_.bindStorage(shared::kGradientsBinding);
    pieceBuffer_.bindStorage(shared::kPiecesBinding);
    blockBuffer_.bindStorage(shared::kBlocksBinding);
}

void GpuSolver::run(const gpu::Program& kernel, uint threads) {
    kernel.dispatch(threads, shared::kGroupSize);
    gpu::storageBarrier();
    ++dispatches_;
}

BodyMeasure GpuSolver::measure() {
    bindBody();
    blockMeasures_.bindStorage(shared::kBlockSumsBinding);
    runOverBlocks(kernels_.measure);
    const auto measures = blockMeasures_.read<shared::BlockMeasure>(0, blocks_.size());
    BodyMeasure out;
    out.pieceVolumes.assign(pieces_.size(), 0.0);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const shared::vec4& low = measures[b].low_volume;
        const shared::vec4& high = measures[b].high_nonfinite;
        out.pieceVolumes[blocks_[b].piece] += low.w;
        out.bounds.add({low.x, low.y, low.z});
        out.bounds.add({high.x, high.y, high.z});
        out.finite = out.finite && high.w == 0.0f;
    }
    return out;
}

BodyState GpuSolver::readState() const {
    return {unpacked(positions_, uniforms_.vertex_count),
            unpacked(velocities_, uniforms_.vertex_count)};
}

std::vector<Vec3f> GpuSolver::readDisplacements() const {
    return unpacked(displacement_, uniforms_.vertex_count);
}

void GpuSolver::saveState() {
    savedPositions_.copyFrom(positions_);
}

void GpuSolver::restoreStateAtRest() {
    assert(savedPositions_.size() == positions_.size());
    positions_.copyFrom(savedPositions_);
    velocities_.clear();
}

BodyView GpuSolver::view() const {
    return {&positions_,
            &restPositions_,
            &triangles_,
            &triangleIncidence_.offsets,
            &triangleIncidence_.entries,
            uniforms_.vertex_count,
            uniforms_.triangle_count};
}

}  // namespace kerf
