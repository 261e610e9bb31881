#include "sim/solve/gpu_solver.h"

#include <cassert>

#include "shaders/shared/bindings.h"
#include "sim/base/pausing.h"
#include "sim/solve/float_vectors.h"

namespace kerf {

SavedPieces::SavedPieces(SolverBody& body)
    : body_(body), kernel_(gpu::Program::compute("sim/restore.comp")) {}

void SavedPieces::restoreAtRest(std::span<const int> pieces) {
    assert(body_.state.saved.size() == body_.state.positions.size());
    std::vector<shared::uint> marks(body_.pieces.pieces().size(), 0);
    for (const int piece : pieces) {
        marks[piece] = 1;
    }
    marks_.assign(marks);
    body_.bind();
    body_.state.saved.bindStorage(shared::kSavedBinding);
    marks_.bindStorage(shared::kMarksBinding);
    body_.run(kernel_, body_.uniforms.vertex_count);
}

using shared::uint;

void GpuSolver::setModel(const BodyModel& model, const BodyState& state) {
    VertexPages pages;
    pages.assign(model.pieceOfVertex, model.pieces.size());
    restoreModel(model, state, std::move(pages));
}

void GpuSolver::restoreModel(const BodyModel& model, const BodyState& state, VertexPages pages) {
    for (int portion = 0; portion < kModelPortions; ++portion) {
        pausePoint();
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
            prepared_.reset();
            restoredSlips_.emplace();
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
            body_.pieces.upload(model, body_.scatter);
            return body_.setCountsOf(model);
        case 6:
            setState(state);
            return collisions_.setBody(model, true);
        default:
            assert(false && "portions end with kModelPortions");
    }
}

void GpuSolver::compileImplicitSteps() {
    if (!implicit_) {
        implicit_.emplace(body_, collisions_);
    }
}

void GpuSolver::stepImplicitly(const BodyModel& model, const Params& params,
                               const ImplicitStep& step, std::vector<uint> pinned) {
    compileImplicitSteps();
    Prepared wanted{params, step.prepared, std::move(pinned)};
    wanted.params.iterations = 0;  // which the body does not depend on
    if (prepared_ != wanted) {
        prepared_.reset();
        implicit_->setBody(model, params, step, wanted.pinned);
        if (restoredSlips_) {
            implicit_->setSlips(*std::exchange(restoredSlips_, std::nullopt));
        }
        prepared_ = std::move(wanted);
    } else {
        implicit_->setStep(params, step);
    }
    stepper_.stepImplicitly(&*implicit_, step.unfolds);
}

void GpuSolver::makeRoom(const BodyModel& model) {
    body_.state.makeRoom(model);
    stepper_.makeRoom(model.restPositions.size());
}

ContactMemory GpuSolver::contactMemory() const {
    ContactMemory memory = collisions_.memory();
    if (restoredSlips_) {
        memory.slips = *restoredSlips_;
    } else if (implicit_) {
        memory.slips = implicit_->slips();
    }
    return memory;
}

void GpuSolver::remember(const ContactMemory& memory) {
    collisions_.remember(memory);
    restoredSlips_ = memory.slips;
}

void GpuSolver::update(const BodyModel& model, const BodyChange& change,
                       std::span<const uint> written, const BodyState& state) {
    prepared_.reset();
    body_.pieces.updatePages(change.pieces.moves, model);
    body_.pieces.upload(model, body_.scatter);
    pausePoint();
    body_.model.update(model, change, body_.scatter);
    pausePoint();
    body_.state.update(written, state, body_.model.areas.size(), body_.scatter);
    makeRoom(model);
    pausePoint();
    body_.setCountsOf(model);
    masses_.invalidate();
    collisions_.setBody(model, false);
}

void GpuSolver::takeMaterials(const BodyModel& model) {
    prepared_.reset();
    body_.pieces.upload(model, body_.scatter);
    body_.model.uploadConstraints(model);
    masses_.invalidate();
}

void GpuSolver::setState(const BodyState& state) {
    assert(state.positions.size() == body_.model.areas.size());
    assert(state.velocities.size() == body_.model.areas.size());
    body_.state.assign(state);
    collisions_.expect(boundsOf(state.positions), boundsOf(state.velocities));
    collisions_.forgetCandidates();
    masses_.compute();
}

std::vector<Vec3f> GpuSolver::readDisplacements() const {
    return unpacked(body_.state.displacement.read<shared::vec4>(0, body_.uniforms.vertex_count));
}

void GpuSolver::step() {
    masses_.refresh();
    stepper_.step(masses_.takeCarries());
}

void GpuSolver::predictAndStretch() {
    masses_.refresh();
    stepper_.phases().predictAndStretch();
}

BodyMeasure GpuSolver::measure() {
    measurer_.start();
    return measurer_.take();
}

BodyView GpuSolver::view() const {
    return bodyViewOf(body_);
}

ConstraintView GpuSolver::constraintView() const {
    return constraintViewOf(body_, collisions_.contacts());
}

}  // namespace kerf
