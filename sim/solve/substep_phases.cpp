#include "sim/solve/substep_phases.h"

#include <string>
#include <utility>

#include "shaders/shared/bindings.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

using gpu::Defines;
using ConstraintKernels = std::array<gpu::Program, kConstraintTypes>;

constexpr uint kLastType = kConstraintTypes - 1;

/// What kernels call the types of constraints and the lists of their vertices.
const std::array<Defines, kConstraintTypes> kNames{{
#define KERF_NAMES(number, Name, list, Constraint, Gather) \
    {{"TYPE", #number},                                    \
     {"FETCH", "fetch" #Name},                             \
     {"SOLVE", "solve" #Name},                             \
     {"SUM", "sumOf" #Gather},                             \
     {"RANGES", "RANGES_OF_" #Gather},                     \
     {"ENTRIES", "ENTRIES_OF_" #Gather}},
    KERF_CONSTRAINTS(KERF_NAMES)
#undef KERF_NAMES
}};

gpu::Program compileFor(const SolverBody& body, const std::string& name, uint type,
                        Defines defines = {}) {
    defines.insert(defines.end(), kNames[type].begin(), kNames[type].end());
    return body.compile(name, std::move(defines));
}

/// A kernel for each type but edges.
ConstraintKernels compileForEach(const SolverBody& body, const std::string& name,
                                 const Defines& defines = {}) {
    ConstraintKernels kernels;
    for (uint type = 1; type < kConstraintTypes; ++type) {
        kernels[type] = compileFor(body, name, type, defines);
    }
    return kernels;
}

}  // namespace

SubstepPhases::SubstepPhases(SolverBody& body)
    : body_(body),
      stretch_(body.compile("stretch")),
      stretchAgain_{body.compile("stretch", {{"SWEEP_AGAIN", "1"}}),
                    body.compile("stretch", {{"SWEEP_AGAIN", "1"}, {"PLAIN_PBD", "1"}})},
      solve_{compileForEach(body, "constraint"),
             compileForEach(body, "constraint", {{"PLAIN_PBD", "1"}})},
      gather_(compileForEach(body, "gather_corrections")),
      gatherOntoFloor_(compileFor(body, "gather_corrections", kLastType, {{"ONTO_FLOOR", "1"}})),
      volumeGradient_(body.compile("volume_gradient", body.groupsOfSums())),
      volumeCorrect_(body.compile("volume_correct")),
      pull_(gpu::Program::compute("sim/pull.comp")),
      floor_(body.compile("floor")),
      finish_(body.compile("finish")),
      settle_(body.compile("settle")) {}

void SubstepPhases::setFolds(const gpu::Buffer* folds) {
    folds_ = folds;
    if (folds_ != nullptr && !foldedKernels_) {
        const Defines folded{{"UNFOLDS", "1"}};
        foldedKernels_.emplace(
            FoldedKernels{body_.compile("stretch", folded), body_.compile("floor", folded),
                          body_.compile("finish", folded), body_.compile("settle", folded),
                          compileForEach(body_, "constraint", folded)});
    }
}

bool SubstepPhases::bindFolds() const {
    if (folds_ != nullptr) {
        folds_->bindTexels(shared::kFoldsUnit, TexelFormat::uint32);
        folds_->bindStorage(shared::kEndedFoldsBinding);
    }
    return folds_ != nullptr;
}

void SubstepPhases::predictAndStretch() {
    body_.bind();
    bindLists(shared::kStretch);
    body_.run(bindFolds() ? foldedKernels_->stretch : stretch_, body_.uniforms.vertex_count);
}

void SubstepPhases::stretchAgain() {
    std::swap(body_.state.displacement, body_.state.previous);
    body_.bind();
    body_.bindFetched(body_.state.previous, shared::kPreviousBinding, TexelFormat::float32x4);
    bindLists(shared::kStretch);
    body_.run(stretchAgain_[solverKind()], body_.uniforms.vertex_count);
}

void SubstepPhases::bindLists(uint type) const {
    const ConstraintBuffers& buffers = body_.model.constraints[type];
    body_.bindFetched(buffers.ranges, shared::kRangesBinding, buffers.rangeTexels);
    body_.bindFetched(buffers.entries, shared::kEntriesBinding, buffers.entryTexels);
}

void SubstepPhases::solve(uint type, const gpu::Program& gather) {
    if (!body_.active(1u << type)) {
        return;
    }
    body_.bind();
    body_.bindFetched(body_.model.constraints[type].records, shared::kConstraintsBinding,
                      TexelFormat::uint32x4);
    const gpu::Buffer& corrections = body_.state.corrections;
    corrections.bindStorage(shared::kCorrectionsBinding);
    body_.bindFetched(corrections, shared::kCorrectionsBinding, TexelFormat::float32x4);
    const ConstraintKernels& kernels = bindFolds() ? foldedKernels_->solve : solve_[solverKind()];
    body_.run(kernels[type], body_.uniforms.count[type]);
    bindLists(type);
    body_.run(gather, body_.uniforms.vertex_count);
}

void SubstepPhases::solveAll(bool ontoFloor) {
    for (uint type = 1; type < kLastType; ++type) {
        solve(type);
    }
    solve(kLastType, ontoFloor ? gatherOntoFloor_ : gather_[kLastType]);
}

bool SubstepPhases::mayGatherOntoFloor() const {
    return body_.active(1u << kLastType) && body_.active(shared::kFloorPart) &&
           !body_.active(shared::kVolumePart);
}

void SubstepPhases::sumVolume() {
    body_.bind();
    body_.pieces.blockSums.bindStorage(shared::kBlockSumsBinding);
    body_.pieces.impulses.bindStorage(shared::kImpulsesBinding);
    if (body_.active(shared::kVolumePart)) {
        body_.runOverBlocks(volumeGradient_);
    }
}

void SubstepPhases::solveVolume() {
    if (body_.active(shared::kVolumePart)) {
        sumVolume();
        body_.run(volumeCorrect_, body_.uniforms.vertex_count);
    }
}

void SubstepPhases::settle() {
    sumVolume();
    body_.run(bindFolds() ? foldedKernels_->settle : settle_, body_.uniforms.vertex_count);
}

void SubstepPhases::pull() {
    if (body_.uniforms.pull_count > 0) {
        body_.bind();
        body_.pulls.bindStorage(shared::kPullsBinding);
        body_.run(pull_, body_.uniforms.pull_count);
    }
}

void SubstepPhases::collideFloor() {
    if (body_.active(shared::kFloorPart)) {
        body_.bind();
        body_.run(bindFolds() ? foldedKernels_->floor : floor_, body_.uniforms.vertex_count);
    }
}

void SubstepPhases::finish() {
    body_.bind();
    body_.run(bindFolds() ? foldedKernels_->finish : finish_, body_.uniforms.vertex_count);
}

}  // namespace kerf
