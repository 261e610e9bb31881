#include "sim/solve/substep_phases.h"

#include <string>
#include <utility>

#include "shaders/shared/bindings.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

/// A kernel that a substep spends its time in: see fetch.glsl for images.
gpu::Program compile(const SolverBody& body, const std::string& name, gpu::Defines defines = {}) {
    if (body.loadsImages) {
        defines.emplace_back("LOAD_IMAGES", "1");
    }
    return gpu::Program::compute("sim/" + name + ".comp", defines);
}

/// llvmpipe resumes a coroutine at each barrier for every eight threads of a group, so that its
/// groups are small.
gpu::Defines groupsOfSums(const SolverBody& body) {
    const uint threads = body.loadsImages ? 8 : shared::kPageSize;
    return {{"SUM_GROUP", std::to_string(threads) + "u"}};
}

}  // namespace

SubstepPhases::SubstepPhases(SolverBody& body)
    : body_(body),
      constraints_{compileConstraints(false), compileConstraints(true)},
      stretch_(compile(body, "stretch")),
      gatherBends_(compile(body, "gather_corrections", {{"GATHER_BENDS", "1"}})),
      gatherIspcs_(compile(body, "gather_corrections", {{"GATHER_ISPCS", "1"}})),
      gatherIspcsOntoFloor_(
          compile(body, "gather_corrections", {{"GATHER_ISPCS", "1"}, {"ONTO_FLOOR", "1"}})),
      volumeGradient_(compile(body, "volume_gradient", groupsOfSums(body))),
      volumeCorrect_(compile(body, "volume_correct")),
      pull_(gpu::Program::compute("sim/pull.comp")),
      floor_(compile(body, "floor")),
      finish_(compile(body, "finish")),
      settle_(compile(body, "settle")) {}

SubstepPhases::ConstraintKernels SubstepPhases::compileConstraints(bool plainPbd) const {
    const auto compileFor = [&](const std::string& name, gpu::Defines defines = {}) {
        if (plainPbd) {
            defines.emplace_back("PLAIN_PBD", "1");
        }
        return compile(body_, name, std::move(defines));
    };
    return {compileFor("stretch", {{"SWEEP_AGAIN", "1"}}), compileFor("bend"), compileFor("ispc")};
}

const SubstepPhases::ConstraintKernels& SubstepPhases::constraints() const {
    return constraints_[body_.plainPbd() ? 1 : 0];
}

void SubstepPhases::setFolds(const gpu::Buffer* folds) {
    folds_ = folds;
    if (folds_ != nullptr && !foldedKernels_) {
        const auto compileFor = [&](const std::string& name) {
            return compile(body_, name, {{"UNFOLDS", "1"}});
        };
        foldedKernels_.emplace(FoldedKernels{compileFor("stretch"), compileFor("bend"),
                                             compileFor("ispc"), compileFor("floor"),
                                             compileFor("settle")});
    }
}

const gpu::Program& SubstepPhases::choose(const gpu::Program& kernel,
                                          gpu::Program FoldedKernels::*folded) const {
    if (folds_ == nullptr) {
        return kernel;
    }
    folds_->bindTexels(shared::kFoldsUnit, TexelFormat::uint32);
    return *foldedKernels_.*folded;
}

void SubstepPhases::predictAndStretch() {
    body_.bind();
    bindSpokes();
    body_.run(choose(stretch_, &FoldedKernels::stretch), body_.uniforms.vertex_count);
}

void SubstepPhases::stretchAgain() {
    std::swap(body_.state.displacement, body_.state.previous);
    body_.bind();
    body_.bindFetched(body_.state.previous, shared::kPreviousBinding, TexelFormat::float32x4);
    bindSpokes();
    body_.run(constraints().stretchAgain, body_.uniforms.vertex_count);
}

void SubstepPhases::bindSpokes() const {
    body_.bindFetched(body_.model.edgeRanges, shared::kRangesBinding, TexelFormat::uint32x2);
    body_.bindFetched(body_.model.spokes, shared::kEntriesBinding, TexelFormat::uint32x4);
}

void SubstepPhases::solveBends() {
    if (!body_.active(shared::kBendPart)) {
        return;
    }
    const SolverModel& model = body_.model;
    body_.bindFetched(model.bends, shared::kConstraintsBinding, TexelFormat::uint32x4);
    runOverConstraints(choose(constraints().bend, &FoldedKernels::bend), body_.uniforms.bend_count);
    body_.bindFetched(model.bendRanges, shared::kRangesBinding, TexelFormat::uint32x4);
    body_.bindFetched(model.bendEntries, shared::kEntriesBinding, TexelFormat::uint32x2);
    body_.run(gatherBends_, body_.uniforms.vertex_count);
}

void SubstepPhases::solveIspcs(const gpu::Program& gather) {
    if (!body_.active(shared::kIspcPart)) {
        return;
    }
    const SolverModel& model = body_.model;
    body_.bindFetched(model.ispcs, shared::kConstraintsBinding, TexelFormat::uint32x4);
    runOverConstraints(choose(constraints().ispc, &FoldedKernels::ispc), body_.uniforms.ispc_count);
    body_.bindFetched(model.ispcRanges, shared::kRangesBinding, TexelFormat::uint32x2);
    body_.bindFetched(model.ispcShares, shared::kEntriesBinding, TexelFormat::uint32x4);
    body_.run(gather, body_.uniforms.vertex_count);
}

bool SubstepPhases::mayGatherOntoFloor() const {
    return body_.active(shared::kIspcPart) && body_.active(shared::kFloorPart) &&
           !body_.active(shared::kVolumePart);
}

void SubstepPhases::runOverConstraints(const gpu::Program& kernel, uint count) {
    body_.bind();
    const gpu::Buffer& corrections = body_.state.corrections;
    corrections.bindStorage(shared::kCorrectionsBinding);
    body_.bindFetched(corrections, shared::kCorrectionsBinding, TexelFormat::float32x4);
    body_.run(kernel, count);
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
    body_.run(choose(settle_, &FoldedKernels::settle), body_.uniforms.vertex_count);
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
        body_.run(choose(floor_, &FoldedKernels::floor), body_.uniforms.vertex_count);
    }
}

void SubstepPhases::finish() {
    body_.bind();
    body_.run(finish_, body_.uniforms.vertex_count);
}

}  // namespace kerf
