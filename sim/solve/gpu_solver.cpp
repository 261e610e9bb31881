#include "sim/solve/gpu_solver.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "shaders/shared/bindings.h"
#include "sim/solve/float_vectors.h"
#include "sim/solve/solver_views.h"

namespace kerf {

using shared::uint;

GpuSolver::GpuSolver() : restore_(gpu::Program::compute("sim/restore.comp")) {}

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
    if (const uint type = static_cast<uint>(portion) / 2; type < kConstraintTypes) {
        return portion % 2 == 0 ? body_.model.uploadRecords(model, type)
                                : body_.model.uploadLists(model, type);
    }
    switch (portion - static_cast<int>(2 * kConstraintTypes)) {
        case 0:
            body_.model.takeVertices(model);
            masses_.freeAll();
            return body_.pieces.setPages(std::move(pages));
        case 1:
            return makeRoom(model);
        case 2:
            body_.state.displacement.clear();
            return body_.model.uploadRestShape(model);
        case 3:
            return body_.model.uploadTriangles(model);
        case 4:
            return body_.model.uploadTriangleLists(model);
        case 5:
            return uploadCounts(model);
        case 6:
            setState(state);
            contactEdgeLength_ = contactEdgeLength(model);
            return setContactBody();
        default:
            assert(false && "portions end with kModelPortions");
    }
}

void GpuSolver::uploadCounts(const BodyModel& model) {
    body_.pieces.upload(model, body_.scatter);
    smallBody_.setBody(model, body_.pieces.blocks(), true);
    sweepsFaster_ = {};
    body_.setCountsOf(model);
}

void GpuSolver::makeRoom(const BodyModel& model) {
    body_.state.makeRoom(model);
    unfolding_.resize(model.restPositions.size());
}

void GpuSolver::update(const BodyModel& model, const BodyChange& change,
                       std::span<const uint> written, const BodyState& state) {
    body_.pieces.updatePages(change.pieces.moves, model);
    body_.pieces.upload(model, body_.scatter);
    body_.model.update(model, change, body_.scatter);
    body_.state.update(written, state, body_.model.areas.size(), body_.scatter);
    makeRoom(model);
    smallBody_.setBody(model, body_.pieces.blocks(), body_.plainPbd());
    body_.setCountsOf(model);
    masses_.invalidate();
    setContactBody();
}

void GpuSolver::setContactBody() {
    const ContactBody body = contactBodyOf(body_);
    contacts_.setBody(body, contactEdgeLength_);
    paperContact_.setBody(body, contactEdgeLength_);
    boxes_.setBody(body, contactEdgeLength_);
    blade_.setBody(body, contactEdgeLength_);
}

void GpuSolver::setContact(const ContactSettings& settings) {
    contacts_.setSettings(settings);
    paperContact_.setSettings(settings);
    boxes_.setSettings(settings);
    blade_.setSettings(settings);
}

void GpuSolver::setState(const BodyState& state) {
    assert(state.positions.size() == body_.model.areas.size());
    assert(state.velocities.size() == body_.model.areas.size());
    body_.state.assign(state);
    setReach(boundsOf(state.positions), boundsOf(state.velocities));
    contacts_.forgetCandidates();
    masses_.compute();
}

bool GpuSolver::unfolds() const {
    return motion_.folded && body_.active(shared::kUnfoldPart);
}

void GpuSolver::step() {
    masses_.refresh();
    contacts_.beginStep(motion_);
    reach_.floor =
        body_.active(shared::kFloorPart) ? body_.uniforms.floor_height : BodyReach::kNoFloor;
    boxes_.beginStep(reach_);
    blade_.beginStep(reach_);
    unfolds_ = unfolds();
    const gpu::Buffer* folds = unfolds_ ? &unfolding_.folds() : nullptr;
    phases_.setFolds(folds);
    smallBody_.setFolds(folds);
    contacts_.setFolds(folds);
    solveStep();
    collideAsThePaper();
}

void GpuSolver::solveStep() {
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

/// It moves X past what candidates were found from.
void GpuSolver::collideAsThePaper() {
    if (!paperContact_.enabled()) {
        return;
    }
    contacts_.forgetCandidates();
    collideTimer_.begin();
    paperContact_.respond(static_cast<uint>(body_.pieces.pieces().size()));
    collideTimer_.end();
}

ContactReadings GpuSolver::contactReadings() const {
    const bool paper = paperContact_.enabled();
    return {paper ? paperContact_.state() : contacts_.state(), contacts_.searchedPositions(),
            paper || contacts_.enabled()};
}

bool GpuSolver::meetsOnlyTheFloor() const {
    return !contacts_.mayTouch() && !blade_.mayTouch() && !boxes_.mayTouch();
}

bool GpuSolver::solvesInOneGroup() const {
    const bool bySubsteps = oneGroupAllowed_ && body_.uniforms.sweeps == 1 && smallBody_.fits();
    return bySubsteps || (sweepsInOneGroup() && !smallBody_.large());
}

bool GpuSolver::sweepsInOneGroup() const {
    return oneGroupAllowed_ && body_.uniforms.sweeps > 1 && body_.plainPbd() &&
           !body_.active(shared::kVolumePart) && body_.uniforms.pull_count == 0 &&
           meetsOnlyTheFloor() && smallBody_.sweepsAtOnce() > 0;
}

/// The cores of llvmpipe may be so far from each other that one of them is done sooner alone; their
/// compute shaders have run when a dispatch returns.
void GpuSolver::stepTheFasterWay() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    sweepsFaster_.next() == 0 ? stepBySweeps() : stepByPhases();
    sweepsFaster_.took(std::chrono::duration<double>(Clock::now() - start).count());
}

/// SubstepRun or SweepRun.
template <class Run>
void GpuSolver::runSmallBody(const Run& run) {
    deformTimer_.begin();
    smallBody_.run(smallBodyBuffersOf(body_), run);
    ++body_.dispatches;
    deformTimer_.end();
}

void GpuSolver::stepBySweeps() {
    const uint sweeps = body_.uniforms.sweeps;
    const uint atOnce = smallBody_.sweepsAtOnce();
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        for (uint first = 0; first < sweeps; first += atOnce) {
            runSmallBody(SweepRun{first, std::min(first + atOnce, sweeps)});
        }
    }
}

void GpuSolver::stepByPhases() {
    const bool settles = settlingAllowed_ && meetsOnlyTheFloor() && body_.uniforms.pull_count == 0;
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        searchContactsBefore(i);
        unfoldBefore();
        boxes_.beginSubstep();
        for (uint sweep = 0; sweep < body_.uniforms.sweeps; ++sweep) {
            deformTimer_.begin();
            sweep == 0 ? predictAndStretch() : stretchAgain();
            const bool last = sweep + 1 == body_.uniforms.sweeps;
            const bool lifts = settles && !last && phases_.mayGatherOntoFloor();
            phases_.solveAll(lifts);
            deformTimer_.end();
            if (!(settles && last) && !lifts) {
                holdVolumeAndCollide(i);
            }
        }
        deformTimer_.begin();
        settles ? phases_.settle() : finishSubstep();
        deformTimer_.end();
    }
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
    for (uint done = 0; done < body_.uniforms.substeps; done += smallBody_.substepsAtOnce()) {
        const uint left = body_.uniforms.substeps - done;
        runSmallBody(SubstepRun{std::min(left, smallBody_.substepsAtOnce()), false, false});
    }
}

/// Contact and boxes act while a substep is open; contacts are looked for and folds unfolded
/// between two.
void GpuSolver::stepBySubsteps() {
    bool open = false;
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        const bool searches = contacts_.searchesBefore(static_cast<int>(i));
        if ((unfolds_ || searches) && std::exchange(open, false)) {
            runSmallBody(SubstepRun{0, true, false});
        }
        if (searches) {
            searchContactsBefore(i);
        }
        unfoldBefore();
        runSmallBody(SubstepRun{1, open, true});
        open = true;
        collideTimer_.begin();
        boxes_.beginSubstep();
        collideBody();
        collideBlade(i);
        collideBoxes(i);
        collideTimer_.end();
    }
    runSmallBody(SubstepRun{0, true, false});
}

void GpuSolver::unfold() {
    unfolding_.run(unfoldingBodyOf(body_));
    body_.dispatches += Unfolding::kDispatches;
}

void GpuSolver::unfoldBefore() {
    if (unfolds_) {
        deformTimer_.begin();
        unfold();
        deformTimer_.end();
    }
}

void GpuSolver::predictAndStretch() {
    masses_.refresh();
    phases_.predictAndStretch();
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

BodyMeasure GpuSolver::takeMeasure() {
    SolverMeasure found = measurer_.take(contactReadings());
    setReach(found.body.bounds, found.body.lostPieces.empty() ? found.velocities : Bounds{});
    motion_.drift = found.ways.diagonal();
    motion_.touching = found.body.contacts > 0;
    motion_.folded = found.folded;
    motion_.hasCandidates = found.hasCandidates;
    return std::move(found.body);
}

/// An empty box of velocities: all at rest.
void GpuSolver::setReach(const Bounds& positions, const Bounds& velocities) {
    constexpr double kMargin = 0.5;  // of the diagonal
    const Vec3 fastest = velocities.low.cwiseAbs().cwiseMax(velocities.high.cwiseAbs());
    motion_ = {velocities.diagonal(), 0, false, true};
    reach_ = {positions, velocities.empty() ? 0.0 : fastest.norm(), kMargin * body_.model.diagonal};
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
    return body_.state.read(body_.uniforms.vertex_count);
}

std::vector<Vec3f> GpuSolver::readDisplacements() const {
    return unpacked(body_.state.displacement, body_.uniforms.vertex_count);
}

void GpuSolver::saveState() {
    body_.state.saved.copyFrom(body_.state.positions);
}

void GpuSolver::restorePiecesAtRest(std::span<const int> pieces) {
    assert(body_.state.saved.size() == body_.state.positions.size());
    std::vector<uint> marks(body_.pieces.pieces().size(), 0);
    for (const int piece : pieces) {
        marks[piece] = 1;
    }
    marks_.assign(marks);
    body_.bind();
    body_.state.saved.bindStorage(shared::kSavedBinding);
    marks_.bindStorage(shared::kMarksBinding);
    body_.run(restore_, body_.uniforms.vertex_count);
}

BodyView GpuSolver::view() const {
    return bodyViewOf(body_);
}

ConstraintView GpuSolver::constraintView() const {
    return constraintViewOf(body_, contacts_);
}

}  // namespace kerf
