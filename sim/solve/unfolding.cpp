#include "sim/solve/unfolding.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/unfold_records.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

void bindBoth(const gpu::Buffer& buffer, uint binding, TexelFormat format) {
    buffer.bindStorage(binding);
    buffer.bindTexels(binding, format);
}

}  // namespace

Unfolding::Unfolding()
    : forgetFolds_(gpu::Program::compute("sim/unfold/not_folded.comp")),
      findFolds_(gpu::Program::compute("sim/unfold/folds.comp")),
      sumFolds_(gpu::Program::compute("sim/unfold/fold_sums.comp")),
      findGoals_(gpu::Program::compute("sim/unfold/goals.comp")),
      unfold_(gpu::Program::compute("sim/unfold/unfold.comp")) {}

void Unfolding::resize(std::size_t vertices) {
    folds_.resize(2 * vertices * sizeof(float));
    goals_.resize(vertices * sizeof(shared::UnfoldGoal));
}

void Unfolding::run(const SolverBody& body) {
    bind(body);
    forgetFolds_.dispatch(body.uniforms.vertex_count);
    findFolds_.dispatch(body.uniforms.count[shared::kBend]);
    sumFolds_.dispatch(body.uniforms.vertex_count);
    findGoals_.dispatch(body.uniforms.vertex_count);
    unfold_.dispatch(body.uniforms.vertex_count);
}

void Unfolding::bind(const SolverBody& body) const {
    body.uniformBuffer.bindStorage(shared::kUniformsBinding);
    body.state.positions.bindTexels(shared::kPositionsBinding, TexelFormat::float32x4);
    bindBoth(body.state.velocities, shared::kVelocitiesBinding, TexelFormat::float32x4);
    body.model.restPositions.bindTexels(shared::kUnfoldRestBinding, TexelFormat::float32x4);
    body.model.constraints[shared::kBend].records.bindTexels(shared::kUnfoldBendsBinding,
                                                             TexelFormat::uint32x4);
    body.model.neighbours.ranges.bindTexels(shared::kRangesBinding, TexelFormat::uint32x2);
    body.model.neighbours.entries.bindTexels(shared::kEntriesBinding, TexelFormat::uint32x2);
    bindBoth(folds_, shared::kUnfoldFoldsBinding, TexelFormat::uint32);
    bindBoth(goals_, shared::kUnfoldGoalsBinding, TexelFormat::float32x4);
}

}  // namespace kerf
