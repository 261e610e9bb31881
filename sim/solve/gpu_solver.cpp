#include "sim/solve/gpu_solver.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <string>
#include <utility>

#include "gpu/context.h"
#include "shaders/shared/bindings.h"
#include "sim/body/incidence.h"
#include "sim/solve/gathered_records.h"
#include "sim/solve/solver_uniforms.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

static_assert(sizeof(shared::SolverUniforms) == 112);
static_assert(sizeof(shared::PullRecord) == 28);
static_assert(sizeof(shared::BendRecord) == 32);
static_assert(sizeof(shared::BendRange) == 16);
static_assert(sizeof(shared::IspcShare) == 8);
static_assert(sizeof(shared::IspcConstraint) == 32);
static_assert(sizeof(shared::VertexLinks) == 16);
static_assert(sizeof(shared::PieceRecord) == 28);
static_assert(sizeof(shared::BlockRecord) == 12);
static_assert(sizeof(shared::IncidenceRange) == 8);
static_assert(sizeof(shared::WordPatch) == 8);
static_assert(sizeof(shared::VolumeSum) == 8);
static_assert(sizeof(shared::VolumeImpulse) == 8);
static_assert(sizeof(shared::Spoke) == 16);
static_assert(sizeof(shared::BlockMeasure) == 96);

// One thread adds up the blocks of a piece, so there are few of them; and a thread goes through the
// pages of a block, so these may not be too many either: llvmpipe ends loops after 65,535 turns.
constexpr uint kBlocksPerPiece = 32;
constexpr uint kMaxPagesPerBlock = 64;

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

shared::VertexLinks linksOf(const BodyModel& model, std::size_t v) {
    const int piece = model.pieceOfVertex[v];
    return {valence(model.edgeIncidence, v), valence(model.bendIncidence, v),
            valence(model.ispcIncidence, v),
            piece < 0 ? shared::kNoPiece : static_cast<uint>(piece)};
}

std::vector<shared::VertexLinks> vertexLinks(const BodyModel& model) {
    std::vector<shared::VertexLinks> links(model.restPositions.size());
    for (std::size_t v = 0; v < links.size(); ++v) {
        links[v] = linksOf(model, v);
    }
    return links;
}

Bounds boundsOf(const std::vector<Vec3f>& values) {
    Bounds box;
    for (const Vec3f& u : values) {
        box.add(u.cast<double>());
    }
    return box;
}

void appendBlocks(std::vector<shared::BlockRecord>& blocks, uint piece, uint firstPage,
                  uint pageCount) {
    const uint size =
        std::min((pageCount + kBlocksPerPiece - 1) / kBlocksPerPiece, kMaxPagesPerBlock);
    for (uint done = 0; done < pageCount; done += size) {
        blocks.push_back({piece, firstPage + done, std::min(size, pageCount - done)});
    }
}

}  // namespace

double runawaySpeed(double diagonal, double gravity) {
    constexpr double kDiagonalsPerSecond = 1000;
    constexpr double kFall = 100;  // [s]
    return kDiagonalsPerSecond * diagonal + kFall * gravity;
}

void GpuSolver::IncidenceBuffers::assign(const Incidence& incidence) {
    ranges.assign(incidence.ranges);
    entries.assign(incidence.entries);
}

GpuSolver::GpuSolver() : loadsImages_(gpu::queryDevice().software) {
    compileConstraints();
    kernels_.measure = gpu::Program::compute("sim/measure.comp");
    kernels_.collect = gpu::Program::compute("sim/collect.comp");
    kernels_.masses = gpu::Program::compute("sim/masses.comp");
    kernels_.pull = gpu::Program::compute("sim/pull.comp");
    kernels_.restore = gpu::Program::compute("sim/restore.comp");
    setPulls({});
}

/// Those that a substep spends its time in: see fetch.glsl for images. llvmpipe resumes a coroutine
/// at each barrier for every eight threads of a group, so that its groups are small.
void GpuSolver::compileConstraints() {
    const auto compile = [&](const std::string& name, gpu::Defines defines = {}) {
        if (loadsImages_) {
            defines.emplace_back("LOAD_IMAGES", "1");
        }
        return gpu::Program::compute("sim/" + name + ".comp", defines);
    };
    kernels_.stretch = compile("stretch");
    for (const bool plain : {false, true}) {
        ConstraintKernels& kernels = plain ? kernels_.plainPbd : kernels_.anySolver;
        const auto compileFor = [&](const std::string& name, gpu::Defines defines = {}) {
            if (plain) {
                defines.emplace_back("PLAIN_PBD", "1");
            }
            return compile(name, std::move(defines));
        };
        kernels.stretchAgain = compileFor("stretch", {{"SWEEP_AGAIN", "1"}});
        kernels.bend = compileFor("bend");
        kernels.ispc = compileFor("ispc");
    }
    kernels_.volumeCorrect = compile("volume_correct");
    kernels_.floor = compile("floor");
    kernels_.finish = compile("finish");
    kernels_.settle = compile("settle");
    kernels_.gatherBends = compile("gather_corrections", {{"GATHER_BENDS", "1"}});
    kernels_.gatherIspcs = compile("gather_corrections", {{"GATHER_ISPCS", "1"}});
    kernels_.gatherOntoFloor =
        compile("gather_corrections", {{"GATHER_ISPCS", "1"}, {"ONTO_FLOOR", "1"}});
    const uint threads = loadsImages_ ? 8 : shared::kPageSize;
    kernels_.volumeGradient =
        compile("volume_gradient", {{"SUM_GROUP", std::to_string(threads) + "u"}});
}

void GpuSolver::setModel(const BodyModel& model, const BodyState& state) {
    VertexPages pages;
    pages.assign(model.pieceOfVertex, model.pieces.size());
    restoreModel(model, state, std::move(pages));
}

void GpuSolver::restoreModel(const BodyModel& model, const BodyState& state, VertexPages pages) {
    for (int portion = 0; portion < kModelPortions; ++portion) {
        setModelPortion(portion, model, state, pages);
    }
}

/// Portions of about the same size: most are one or two of the large buffers.
void GpuSolver::setModelPortion(int portion, const BodyModel& model, const BodyState& state,
                                VertexPages& pages) {
    switch (portion) {
        case 0:
            return takeModel(model, pages);
        case 1:
            return resizeScratch(model);
        case 2:
            return uploadRestShape(model);
        case 3:
            return triangles_.assign(model.triangles);
        case 4:
            edgeRanges_.assign(model.edgeIncidence.ranges);
            return spokes_.assign(allSpokes(model));
        case 5:
            return bends_.assign(allBendRecords(model));
        case 6:
            return ispcs_.assign(model.ispcs);
        case 7:
            bendLists_.assign(model);
            bendRanges_.assign(bendLists_.ranges);
            return bendEntries_.assign(bendLists_.entries);
        case 8:
            ispcRanges_.assign(model.ispcIncidence.ranges);
            return ispcShares_.assign(allIspcShares(model));
        case 9:
            return uploadTriangleLists(model);
        case 10:
            return uploadCounts(model);
        case 11:
            return uploadState(model, state);
        default:
            assert(false && "portions end with kModelPortions");
    }
}

void GpuSolver::takeModel(const BodyModel& model, VertexPages& pages) {
    areas_.assign(model.vertexAreas.begin(), model.vertexAreas.end());
    pieceOf_ = model.pieceOfVertex;
    pinned_.clear();
    diagonal_ = boundsOf(model.restPositions).diagonal();
    pages_ = std::move(pages);
    pages_.takeChangedPlaces();
    placeBuffer_.assign(pages_.places());
}

void GpuSolver::uploadRestShape(const BodyModel& model) {
    displacement_.clear();
    restPositions_.assign(packed(model.restPositions));
    cutSkinNormals_.assign(packed(model.cutSkinNormals));
    links_.assign(vertexLinks(model));
    areaBuffer_.assign(areas_);
}

void GpuSolver::uploadTriangleLists(const BodyModel& model) {
    triangleIncidence_.assign(model.triangleIncidence);
    neighbours_.assign(model.neighbours);
}

void GpuSolver::uploadCounts(const BodyModel& model) {
    uploadPieces(model);
    smallBody_.setBody(model, blocks_, true);
    sweepsFaster_ = {};
    setCounts(uniforms_, model);
    uploadUniforms();
}

void GpuSolver::uploadState(const BodyModel& model, const BodyState& state) {
    setState(state);
    contactEdgeLength_ = contactEdgeLength(model);
    setContactBody();
}

void GpuSolver::resizeScratch(const BodyModel& model) {
    const std::size_t vertexBytes = model.restPositions.size() * sizeof(shared::vec4);
    displacement_.resize(vertexBytes);
    previous_.resize(vertexBytes);
    unfolding_.resize(model.restPositions.size());
    gradients_.resize(vertexBytes);
    corrections_.resize(sizeof(shared::vec4) *
                        std::max({2 * model.bends.size(), model.ispcs.size(), std::size_t{1}}));
}

/// Few records each, however large the body: pages hold hundreds of vertices.
void GpuSolver::uploadPieces(const BodyModel& model) {
    std::vector<uint> pageTable;
    pieces_.clear();
    blocks_.clear();
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        const PieceModel& piece = model.pieces[p];
        const std::vector<uint>& pages = pages_.pagesOf(p);
        const uint firstBlock = size32(blocks_.size());
        appendBlocks(blocks_, size32(p), size32(pageTable.size()), size32(pages.size()));
        pageTable.insert(pageTable.end(), pages.begin(), pages.end());
        const uint origin =
            piece.rimVertex >= 0 ? static_cast<uint>(piece.rimVertex) : pages_.anyVertexOf(p);
        pieces_.push_back({origin, firstBlock, size32(blocks_.size()) - firstBlock,
                           piece.holdsVolume ? 1u : 0u, static_cast<float>(piece.restVolume),
                           static_cast<float>(piece.massPerArea),
                           static_cast<float>(piece.leastArea)});
    }
    scatter_.write<uint>(placeBuffer_, pages_.places(), pages_.takeChangedPlaces());
    pageBuffer_.assign(pageTable);
    pieceBuffer_.assign(pieces_);
    blockBuffer_.assign(blocks_);
    blockSums_.resize(std::max<std::size_t>(blocks_.size(), 1) * sizeof(shared::VolumeSum));
    impulses_.resize(std::max<std::size_t>(pieces_.size(), 1) * sizeof(shared::VolumeImpulse));
    blockMeasures_.resize((blocks_.size() + 1) * sizeof(shared::BlockMeasure));
}

void GpuSolver::update(const BodyModel& model, const BodyChange& change,
                       std::span<const uint> written, const BodyState& state) {
    pages_.update(change.pieces.moves, model.restPositions.size(), model.pieces.size());
    uploadPieces(model);
    updateVertices(model, change);
    updateState(written, state);
    updateRecords(model, change);
    resizeScratch(model);
    smallBody_.setBody(model, blocks_, plainPbd());
    setCounts(uniforms_, model);
    uploadUniforms();
    massesLag_ = true;
    setContactBody();
}

void GpuSolver::setContactBody() {
    const ContactBody body{&positions_,
                           &velocities_,
                           &displacement_,
                           &restPositions_,
                           &links_,
                           &pieceBuffer_,
                           &triangles_,
                           &triangleIncidence_.ranges,
                           &triangleIncidence_.entries,
                           uniforms_.vertex_count,
                           uniforms_.triangle_count};
    contacts_.setBody(body, contactEdgeLength_);
    boxes_.setBody(body, contactEdgeLength_);
    blade_.setBody(body, contactEdgeLength_);
}

void GpuSolver::setContact(const ContactSettings& settings) {
    contacts_.setSettings(settings);
    boxes_.setSettings(settings);
    blade_.setSettings(settings);
}

void GpuSolver::updateVertices(const BodyModel& model, const BodyChange& change) {
    const std::size_t n = model.restPositions.size();
    areas_.resize(n);
    pieceOf_.resize(n, -1);
    for (const uint v : change.vertices) {
        areas_[v] = static_cast<float>(model.vertexAreas[v]);
        pieceOf_[v] = model.pieceOfVertex[v];
    }
    const auto fill = Scatter::Gaps::fill;
    scatter_.write<shared::VertexLinks>(links_, n, change.vertices, fill,
                                        [&](uint v) { return linksOf(model, v); });
    scatter_.write<shared::vec4>(restPositions_, n, change.vertices, fill,
                                 [&](uint v) { return packed(model.restPositions[v], 0.0f); });
    scatter_.write<shared::vec4>(cutSkinNormals_, n, change.vertices, fill,
                                 [&](uint v) { return packed(model.cutSkinNormals[v], 0.0f); });
    scatter_.write<float>(areaBuffer_, areas_, change.vertices);
}

void GpuSolver::updateState(std::span<const uint> written, const BodyState& state) {
    assert(state.positions.size() == written.size() && state.velocities.size() == written.size());
    const auto place = [&](uint v) {
        return std::lower_bound(written.begin(), written.end(), v) - written.begin();
    };
    const auto keep = Scatter::Gaps::keep;
    for (gpu::Buffer* buffer : {&positions_, &savedPositions_}) {
        scatter_.write<shared::vec4>(*buffer, areas_.size(), written, keep, [&](uint v) {
            return packed(state.positions[place(v)], 0.0f);
        });
    }
    scatter_.write<shared::vec4>(velocities_, areas_.size(), written, keep,
                                 [&](uint v) { return packed(state.velocities[place(v)], 0.0f); });
}

void GpuSolver::updateRecords(const BodyModel& model, const BodyChange& change) {
    scatter_.write<std::array<uint, 4>>(triangles_, model.triangles, change.triangles);
    scatter_.write<shared::BendRecord>(bends_, model.bends.size(), change.bends,
                                       Scatter::Gaps::fill,
                                       [&](uint b) { return bendRecord(model.bends[b]); });
    scatter_.write<shared::IspcConstraint>(ispcs_, model.ispcs, change.ispcs);
    updateSpokes(model, change);
    updateBendLists(model, change);
    updateIspcShares(model, change);
    updateLists(triangleIncidence_, model.triangleIncidence, change.triangleLists);
    updateLists(neighbours_, model.neighbours, change.neighbourLists);
}

void GpuSolver::updateSpokes(const BodyModel& model, const BodyChange& change) {
    scatter_.write<IncidenceRange>(edgeRanges_, model.edgeIncidence.ranges, change.edgeLists);
    scatter_.write<shared::Spoke>(spokes_, model.edgeIncidence.entries.size(),
                                  changedSpokes(model, change), Scatter::Gaps::keep,
                                  [&](uint place) { return spokeAt(model, place); });
}

void GpuSolver::updateBendLists(const BodyModel& model, const BodyChange& change) {
    bendLists_.update(model, change.bendLists);
    scatter_.write<shared::BendRange>(bendRanges_, bendLists_.ranges, change.bendLists);
    scatter_.write<uint>(bendEntries_, bendLists_.entries,
                         placesOf(model.bendIncidence, change.bendLists));
}

void GpuSolver::updateIspcShares(const BodyModel& model, const BodyChange& change) {
    scatter_.write<IncidenceRange>(ispcRanges_, model.ispcIncidence.ranges, change.ispcLists);
    scatter_.write<shared::IspcShare>(ispcShares_, model.ispcIncidence.entries.size(),
                                      changedIspcShares(model, change), Scatter::Gaps::keep,
                                      [&](uint place) { return ispcShareAt(model, place); });
}

void GpuSolver::updateLists(IncidenceBuffers& buffers, const Incidence& incidence,
                            const std::vector<uint>& vertices) {
    scatter_.write<IncidenceRange>(buffers.ranges, incidence.ranges, vertices);
    scatter_.write<uint>(buffers.entries, incidence.entries, placesOf(incidence, vertices));
}

void GpuSolver::setState(const BodyState& state) {
    assert(state.positions.size() == areas_.size());
    assert(state.velocities.size() == areas_.size());
    positions_.assign(packed(state.positions));
    velocities_.assign(packed(state.velocities));
    setReach(boundsOf(state.positions), boundsOf(state.velocities));
    contacts_.forgetCandidates();
    setMasses();
}

/// After a cut all masses of a piece change: that waits for the next step, which looks at every
/// vertex anyway.
void GpuSolver::refreshMasses() {
    if (massesLag_) {
        setMasses();
    }
}

void GpuSolver::setMasses() {
    massesLag_ = false;
    bindBody();
    areaBuffer_.bindStorage(shared::kAreasBinding);
    run(kernels_.masses, uniforms_.vertex_count);
    holdPins();
}

void GpuSolver::holdPins() {
    std::vector<uint> masses;
    for (const uint v : pinned_) {
        masses.push_back(4 * v + 3);
    }
    const auto keep = Scatter::Gaps::keep;
    scatter_.write<float>(positions_, 4 * areas_.size(), masses, keep, [](uint) { return 0.0f; });
    scatter_.write<shared::vec4>(velocities_, areas_.size(), pinned_, keep,
                                 [](uint) { return shared::vec4{}; });
}

void GpuSolver::setPinned(std::vector<uint> vertices) {
    pinned_ = std::move(vertices);
    massesLag_ = true;
}

void GpuSolver::setPulls(const std::vector<shared::PullRecord>& pulls) {
    if (pulls.empty() && uniforms_.pull_count == 0 && pulls_.size() > 0) {
        return;
    }
    pulls_.assign(pulls);
    uniforms_.pull_count = size32(pulls.size());
    uploadUniforms();
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
    uniforms_.pull_count = counts.pull_count;
    uploadUniforms();
}

void GpuSolver::uploadUniforms() {
    const shared::vec4& g = uniforms_.gravity;
    uniforms_.runaway_speed =
        static_cast<float>(runawaySpeed(diagonal_, Vec3(g.x, g.y, g.z).norm()));
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
    refreshMasses();
    if (isPinned(vertex)) {
        return;
    }
    setInverseUnitMass(vertex, 0.0f);
    const shared::vec4 value = packed(velocity, 0.0f);
    velocities_.write(vertex, std::span<const shared::vec4>(&value, 1));
}

void GpuSolver::release(int vertex) {
    if (isPinned(vertex)) {
        return;
    }
    // As the kernel has it.
    const int p = pieceOf_[vertex];
    const float mass =
        p < 0 ? 0.0f : pieces_[p].mass_per_area * std::max(areas_[vertex], pieces_[p].least_area);
    setInverseUnitMass(vertex, mass > 0.0f ? 1.0f / mass : 0.0f);
}

void GpuSolver::carry(std::span<const uint> vertices, std::span<const Vec3f> velocities) {
    assert(velocities.size() == vertices.size());
    refreshMasses();
    scatter_.write<shared::vec4>(velocities_, areas_.size(), vertices, Scatter::Gaps::keep,
                                 [&](uint v) {
                                     const auto at = std::ranges::lower_bound(vertices, v);
                                     return packed(velocities[at - vertices.begin()], 0.0f);
                                 });
}

void GpuSolver::setInverseUnitMass(int vertex, float value) {
    const std::size_t w = 4 * static_cast<std::size_t>(vertex) + 3;
    positions_.write(w, std::span<const float>(&value, 1));
}

void GpuSolver::step() {
    refreshMasses();
    contacts_.beginStep(motion_);
    boxes_.beginStep(reach_);
    blade_.beginStep(reach_);
    unfolds_ = motion_.folded && active(shared::kUnfoldPart);
    if (sweepsInOneGroup() && smallBody_.large()) {
        stepTheFasterWay();
    } else if (sweepsInOneGroup()) {
        stepBySweeps();
    } else if (!solvesInOneGroup()) {
        stepByPhases();
    } else if (meetsOnlyTheFloor() && !unfolds_) {
        stepAtOnce();
    } else {
        stepBySubsteps();
    }
}

bool GpuSolver::meetsOnlyTheFloor() const {
    return !contacts_.mayTouch() && !blade_.mayTouch() && !boxes_.mayTouch();
}

bool GpuSolver::solvesInOneGroup() const {
    const bool bySubsteps = oneGroupAllowed_ && uniforms_.sweeps == 1 && smallBody_.fits();
    return bySubsteps || (sweepsInOneGroup() && !smallBody_.large());
}

bool GpuSolver::sweepsInOneGroup() const {
    return oneGroupAllowed_ && uniforms_.sweeps > 1 && plainPbd() && !active(shared::kVolumePart) &&
           uniforms_.pull_count == 0 && meetsOnlyTheFloor() && smallBody_.sweepsAtOnce() > 0;
}

/// The cores of llvmpipe may be so far from each other that one of them is done sooner alone; their
/// compute shaders have run when a dispatch returns.
void GpuSolver::stepTheFasterWay() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    sweepsFaster_.next() == 0 ? stepBySweeps() : stepByPhases();
    sweepsFaster_.took(std::chrono::duration<double>(Clock::now() - start).count());
}

void GpuSolver::stepBySweeps() {
    deformTimer_.begin();
    const uint atOnce = smallBody_.sweepsAtOnce();
    for (uint i = 0; i < uniforms_.substeps; ++i) {
        for (uint first = 0; first < uniforms_.sweeps; first += atOnce) {
            smallBody_.run(smallBodyBuffers(),
                           SweepRun{first, std::min(first + atOnce, uniforms_.sweeps)});
            ++dispatches_;
        }
    }
    deformTimer_.end();
}

void GpuSolver::stepByPhases() {
    const bool settles = settlingAllowed_ && meetsOnlyTheFloor() && uniforms_.pull_count == 0;
    for (uint i = 0; i < uniforms_.substeps; ++i) {
        searchContactsBefore(i);
        unfoldBefore();
        for (uint sweep = 0; sweep < uniforms_.sweeps; ++sweep) {
            deformTimer_.begin();
            sweep == 0 ? predictAndStretch() : stretchAgain();
            solveBends();
            const bool last = sweep + 1 == uniforms_.sweeps;
            const bool lifts = settles && !last && liftsInGather();
            solveIspcs(lifts ? kernels_.gatherOntoFloor : kernels_.gatherIspcs);
            deformTimer_.end();
            if (!(settles && last) && !lifts) {
                holdVolumeAndCollide(i);
            }
        }
        deformTimer_.begin();
        settles ? settle() : finishSubstep();
        deformTimer_.end();
    }
}

/// Whether all that follows the ISPCs in a sweep is the floor.
bool GpuSolver::liftsInGather() const {
    return active(shared::kIspcPart) && active(shared::kFloorPart) && !active(shared::kVolumePart);
}

void GpuSolver::holdVolumeAndCollide(uint substep) {
    deformTimer_.begin();
    solveVolume();
    deformTimer_.end();
    collideTimer_.begin();
    pull();
    collideBody();
    collideBlade(substep);
    collideBoxes(substep);
    collideFloor();
    collideTimer_.end();
}

void GpuSolver::stepAtOnce() {
    for (uint done = 0; done < uniforms_.substeps; done += smallBody_.substepsAtOnce()) {
        const uint left = uniforms_.substeps - done;
        runSmallBody({std::min(left, smallBody_.substepsAtOnce()), false, false});
    }
}

/// Contact and boxes act while a substep is open; contacts are looked for and folds unfolded
/// between two.
void GpuSolver::stepBySubsteps() {
    bool open = false;
    for (uint i = 0; i < uniforms_.substeps; ++i) {
        const bool searches = contacts_.searchesBefore(static_cast<int>(i));
        if ((unfolds_ || searches) && std::exchange(open, false)) {
            runSmallBody({0, true, false});
        }
        if (searches) {
            searchContactsBefore(i);
        }
        unfoldBefore();
        runSmallBody({1, open, true});
        open = true;
        collideTimer_.begin();
        collideBody();
        collideBlade(i);
        collideBoxes(i);
        collideTimer_.end();
    }
    runSmallBody({0, true, false});
}

void GpuSolver::unfold() {
    unfolding_.run({.uniforms = &uniformBuffer_,
                    .positions = &positions_,
                    .velocities = &velocities_,
                    .restPositions = &restPositions_,
                    .bends = &bends_,
                    .neighbourRanges = &neighbours_.ranges,
                    .neighbours = &neighbours_.entries,
                    .vertexCount = uniforms_.vertex_count,
                    .bendCount = uniforms_.bend_count});
    dispatches_ += Unfolding::kDispatches;
}

void GpuSolver::unfoldBefore() {
    if (unfolds_) {
        deformTimer_.begin();
        unfold();
        deformTimer_.end();
    }
}

void GpuSolver::runSmallBody(const SubstepRun& run) {
    deformTimer_.begin();
    smallBody_.run(smallBodyBuffers(), run);
    ++dispatches_;
    deformTimer_.end();
}

SmallBodyBuffers GpuSolver::smallBodyBuffers() const {
    return {.uniforms = &uniformBuffer_,
            .positions = &positions_,
            .velocities = &velocities_,
            .displacement = &displacement_,
            .swept = &previous_,
            .links = &links_,
            .edgeRanges = &edgeRanges_,
            .spokes = &spokes_,
            .bends = &bends_,
            .bendRanges = &bendRanges_,
            .bendEntries = &bendEntries_,
            .ispcs = &ispcs_,
            .ispcRanges = &ispcRanges_,
            .ispcShares = &ispcShares_,
            .neighbourRanges = &neighbours_.ranges,
            .neighbours = &neighbours_.entries,
            .places = &placeBuffer_,
            .corrections = &corrections_,
            .gradients = &gradients_,
            .impulses = &impulses_,
            .pieces = &pieceBuffer_,
            .blocks = &blockBuffer_,
            .pages = &pageBuffer_,
            .pulls = &pulls_};
}

void GpuSolver::predictAndStretch() {
    refreshMasses();
    bindBody();
    bindSpokes();
    run(kernels_.stretch, uniforms_.vertex_count);
}

void GpuSolver::stretchAgain() {
    std::swap(displacement_, previous_);
    bindBody();
    bindFetched(previous_, shared::kPreviousBinding, TexelFormat::float32x4);
    bindSpokes();
    run(constraintKernels().stretchAgain, uniforms_.vertex_count);
}

void GpuSolver::bindSpokes() const {
    bindFetched(edgeRanges_, shared::kRangesBinding, TexelFormat::uint32x2);
    bindFetched(spokes_, shared::kEntriesBinding, TexelFormat::uint32x4);
}

/// For measure(), which reads the triangles around each vertex besides.
void GpuSolver::bindConstraints() const {
    edgeRanges_.bindTexels(shared::kEdgeRangesBinding, TexelFormat::uint32x2);
    spokes_.bindTexels(shared::kSpokesBinding, TexelFormat::uint32x4);
    bends_.bindTexels(shared::kBendsBinding, TexelFormat::uint32x4);
    ispcs_.bindTexels(shared::kIspcsBinding, TexelFormat::uint32x4);
}

void GpuSolver::solveBends() {
    if (active(shared::kBendPart)) {
        bindFetched(bends_, shared::kConstraintsBinding, TexelFormat::uint32x4);
        runOverConstraints(constraintKernels().bend, uniforms_.bend_count);
        bindFetched(bendRanges_, shared::kRangesBinding, TexelFormat::uint32x4);
        bindFetched(bendEntries_, shared::kEntriesBinding, TexelFormat::uint32x2);
        run(kernels_.gatherBends, uniforms_.vertex_count);
    }
}

/// Those compiled for plain PBD give the same bits, where nothing is damped or gives way.
const GpuSolver::ConstraintKernels& GpuSolver::constraintKernels() const {
    return plainPbd() ? kernels_.plainPbd : kernels_.anySolver;
}

bool GpuSolver::plainPbd() const {
    return !active(shared::kPullAsBeforePart) && uniforms_.damping_ratio == 0 &&
           uniforms_.stretch_compliance == 0 && uniforms_.bend_compliance == 0 &&
           uniforms_.ispc_compliance == 0;
}

void GpuSolver::solveIspcs() {
    solveIspcs(kernels_.gatherIspcs);
}

void GpuSolver::solveIspcs(const gpu::Program& gather) {
    if (active(shared::kIspcPart)) {
        bindFetched(ispcs_, shared::kConstraintsBinding, TexelFormat::uint32x4);
        runOverConstraints(constraintKernels().ispc, uniforms_.ispc_count);
        bindFetched(ispcRanges_, shared::kRangesBinding, TexelFormat::uint32x2);
        bindFetched(ispcShares_, shared::kEntriesBinding, TexelFormat::uint32x4);
        run(gather, uniforms_.vertex_count);
    }
}

void GpuSolver::runOverConstraints(const gpu::Program& kernel, uint count) {
    bindBody();
    corrections_.bindStorage(shared::kCorrectionsBinding);
    bindFetched(corrections_, shared::kCorrectionsBinding, TexelFormat::float32x4);
    run(kernel, count);
}

void GpuSolver::sumVolume() {
    bindBody();
    blockSums_.bindStorage(shared::kBlockSumsBinding);
    impulses_.bindStorage(shared::kImpulsesBinding);
    if (active(shared::kVolumePart)) {
        runOverBlocks(kernels_.volumeGradient);
    }
}

void GpuSolver::solveVolume() {
    if (active(shared::kVolumePart)) {
        sumVolume();
        run(kernels_.volumeCorrect, uniforms_.vertex_count);
    }
}

void GpuSolver::settle() {
    sumVolume();
    run(kernels_.settle, uniforms_.vertex_count);
}

void GpuSolver::runOverBlocks(const gpu::Program& kernel) {
    bindFetched(neighbours_.ranges, shared::kRangesBinding, TexelFormat::uint32x2);
    bindFetched(neighbours_.entries, shared::kEntriesBinding, TexelFormat::uint32x2);
    bindFetched(placeBuffer_, shared::kPlacesBinding, TexelFormat::uint32);
    pageBuffer_.bindStorage(shared::kPagesBinding);
    run(kernel, size32(blocks_.size()) * shared::kGroupSize);
}

void GpuSolver::pull() {
    if (uniforms_.pull_count > 0) {
        bindBody();
        pulls_.bindStorage(shared::kPullsBinding);
        run(kernels_.pull, uniforms_.pull_count);
    }
}

void GpuSolver::searchContactsBefore(uint substep) {
    if (contacts_.enabled()) {
        collideTimer_.begin();
        contacts_.beforeSubstep(static_cast<int>(substep));
        collideTimer_.end();
    }
}

void GpuSolver::searchContacts() {
    contacts_.beginStep(motion_);
    contacts_.search();
}

void GpuSolver::collideBody() {
    contacts_.respond();
}

void GpuSolver::collideBlade(uint substep) {
    blade_.respond(static_cast<int>(substep));
}

void GpuSolver::collideBoxes(uint substep) {
    boxes_.respond(static_cast<int>(substep));
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

void GpuSolver::bindFetched(const gpu::Buffer& buffer, uint binding, TexelFormat format) const {
    buffer.bindTexels(binding, format);
    if (loadsImages_) {
        buffer.bindImage(binding, format);
    }
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
    bindFetched(positions_, shared::kPositionsBinding, TexelFormat::float32x4);
    bindFetched(velocities_, shared::kVelocitiesBinding, TexelFormat::float32x4);
    bindFetched(displacement_, shared::kDisplacementBinding, TexelFormat::float32x4);
    bindFetched(links_, shared::kLinksBinding, TexelFormat::uint32x4);
    bindFetched(gradients_, shared::kGradientsBinding, TexelFormat::float32x4);
}

void GpuSolver::run(const gpu::Program& kernel, uint threads) {
    kernel.dispatch(threads, shared::kGroupSize);
    gpu::storageBarrier();
    ++dispatches_;
}

BodyMeasure GpuSolver::measure() {
    bindBody();
    blockMeasures_.bindStorage(shared::kBlockSumsBinding);
    contacts_.state().bindStorage(shared::kContactCountsOfStepBinding);
    // Of another body it has another size; candidates are then looked for anyway.
    const gpu::Buffer& searched = contacts_.searchedPositions();
    (searched.size() == positions_.size() ? searched : positions_)
        .bindStorage(shared::kSearchedBinding);
    if (nearby_.asks()) {
        nearby_.renew();
    }
    nearby_.bind();
    bindConstraints();
    runOverBlocks(kernels_.measure);
    collectAsked(nearby_);
    const auto measures = blockMeasures_.read<shared::BlockMeasure>(0, blocks_.size() + 1);
    BodyMeasure out;
    Bounds speeds;
    Bounds ways;
    float largestFold = 0;
    out.pieceVolumes.assign(pieces_.size(), 0.0);
    std::vector<Bounds>& boxes = out.pieceBounds;
    boxes.resize(pieces_.size());
    std::vector<bool> lost(pieces_.size(), false);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const shared::vec4& low = measures[b].low_volume;
        const shared::vec4& high = measures[b].high_lost;
        const uint piece = blocks_[b].piece;
        const shared::vec4& slow = measures[b].low_velocity_kinetic;
        const shared::vec4& fast = measures[b].high_velocity_potential;
        const shared::vec4& leastWay = measures[b].low_drift_strain;
        out.pieceVolumes[piece] += low.w;
        out.kineticEnergy += slow.w;
        out.potentialEnergy += fast.w;
        out.strainEnergy += leastWay.w;
        largestFold = std::max(largestFold, measures[b].high_drift.w);
        lost[piece] = lost[piece] || high.w != 0.0f;
        if (low.x > high.x) {
            continue;  // all vertices of the block's pages have gone to other pieces
        }
        boxes[piece].add({low.x, low.y, low.z});
        boxes[piece].add({high.x, high.y, high.z});
        speeds.add({slow.x, slow.y, slow.z});
        speeds.add({fast.x, fast.y, fast.z});
        ways.add({leastWay.x, leastWay.y, leastWay.z});
        ways.add({measures[b].high_drift.x, measures[b].high_drift.y, measures[b].high_drift.z});
    }
    for (std::size_t p = 0; p < boxes.size(); ++p) {
        out.bounds.add(boxes[p]);
        if (lost[p] || boxes[p].diagonal() > kLargestPiece * diagonal_) {
            out.lostPieces.push_back(static_cast<int>(p));
        }
    }
    out.contacts =
        contacts_.enabled() ? static_cast<int>(measures[blocks_.size()].low_volume.x) : 0;
    setReach(out.bounds, out.lostPieces.empty() ? speeds : Bounds{});
    motion_.drift = ways.diagonal();
    motion_.touching = out.contacts > 0;
    motion_.folded = largestFold > 0;
    motion_.hasCandidates = measures[blocks_.size()].low_volume.y > 0;
    return out;
}

VertexStates GpuSolver::statesOf(std::span<const int> vertices) {
    collected_.ask(std::nullopt, vertices);
    bindBody();
    collectAsked(collected_);
    return collected_.take();
}

void GpuSolver::collectAsked(const NearbyVertices& query) {
    if (query.asked() > 0) {
        query.bind();
        run(kernels_.collect, query.asked());
    }
}

/// An empty box of velocities: all at rest.
void GpuSolver::setReach(const Bounds& positions, const Bounds& velocities) {
    constexpr double kMargin = 0.5;  // of the diagonal
    const Vec3 fastest = velocities.low.cwiseAbs().cwiseMax(velocities.high.cwiseAbs());
    motion_ = {velocities.diagonal(), 0, false, true};
    reach_ = {positions, velocities.empty() ? 0.0 : fastest.norm(), kMargin * diagonal_};
}

ContactMemory GpuSolver::contactMemory() const {
    ContactMemory memory = contacts_.memory();
    memory.motion = motion_;
    return memory;
}

void GpuSolver::rememberContacts(const ContactMemory& memory) {
    contacts_.remember(memory);
    motion_ = memory.motion;
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

void GpuSolver::restorePiecesAtRest(std::span<const int> pieces) {
    assert(savedPositions_.size() == positions_.size());
    std::vector<uint> marks(pieces_.size(), 0);
    for (const int piece : pieces) {
        marks[piece] = 1;
    }
    marks_.assign(marks);
    bindBody();
    savedPositions_.bindStorage(shared::kSavedBinding);
    marks_.bindStorage(shared::kMarksBinding);
    run(kernels_.restore, uniforms_.vertex_count);
}

BodyView GpuSolver::view() const {
    return {&positions_,
            &restPositions_,
            &cutSkinNormals_,
            &triangles_,
            &triangleIncidence_.ranges,
            &triangleIncidence_.entries,
            uniforms_.vertex_count,
            uniforms_.triangle_count};
}

ConstraintView GpuSolver::constraintView() const {
    ConstraintView view;
    view.bends = &bends_;
    view.ispcs = &ispcs_;
    view.pulls = &pulls_;
    view.bendCount = uniforms_.bend_count;
    view.ispcCount = uniforms_.ispc_count;
    view.pullCount = uniforms_.pull_count;
    if (contacts_.enabled() && contacts_.records().size() > 0) {
        view.contacts = &contacts_.records();
        view.contactState = &contacts_.state();
        view.mostContacts = uniforms_.vertex_count;
    }
    return view;
}

}  // namespace kerf
