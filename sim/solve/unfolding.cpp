#include "sim/solve/unfolding.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/unfold_records.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

static_assert(sizeof(shared::UnfoldGoal) == 80);

void bindBoth(const gpu::Buffer& buffer, uint binding, TexelFormat format) {
    buffer.bindStorage(binding);
    buffer.bindTexels(binding, format);
}

void runOver(const gpu::Program& kernel, uint threads) {
    kernel.dispatch(threads, shared::kGroupSize);
    gpu::storageBarrier();
}

}  // namespace

Unfolding::Unfolding()
    : findFolds_(gpu::Program::compute("sim/unfold/folds.comp")),
      sumFolds_(gpu::Program::compute("sim/unfold/fold_sums.comp")),
      findGoals_(gpu::Program::compute("sim/unfold/goals.comp")),
      unfold_(gpu::Program::compute("sim/unfold/unfold.comp")) {}

void Unfolding::resize(std::size_t vertices) {
    folds_.resize(vertices * sizeof(float));
    foldSums_.resize(vertices * sizeof(float));
    goals_.resize(vertices * sizeof(shared::UnfoldGoal));
}

void Unfolding::run(const UnfoldingBody& body) {
    folds_.clear();
    bind(body);
    runOver(findFolds_, body.bendCount);
    runOver(sumFolds_, body.vertexCount);
    runOver(findGoals_, body.vertexCount);
    runOver(unfold_, body.vertexCount);
}

void Unfolding::bind(const UnfoldingBody& body) const {
    body.uniforms->bindStorage(shared::kUniformsBinding);
    body.positions->bindTexels(shared::kPositionsBinding, TexelFormat::float32x4);
    bindBoth(*body.velocities, shared::kVelocitiesBinding, TexelFormat::float32x4);
    body.restPositions->bindTexels(shared::kUnfoldRestBinding, TexelFormat::float32x4);
    body.bends->bindTexels(shared::kUnfoldBendsBinding, TexelFormat::uint32x4);
    body.neighbourRanges->bindTexels(shared::kRangesBinding, TexelFormat::uint32x2);
    body.neighbours->bindTexels(shared::kEntriesBinding, TexelFormat::uint32x2);
    bindBoth(folds_, shared::kUnfoldFoldsBinding, TexelFormat::uint32);
    bindBoth(foldSums_, shared::kUnfoldFoldSumsBinding, TexelFormat::uint32);
    bindBoth(goals_, shared::kUnfoldGoalsBinding, TexelFormat::float32x4);
}

}  // namespace kerf
