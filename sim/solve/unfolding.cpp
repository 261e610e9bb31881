#include "sim/solve/unfolding.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/unfold_records.h"

namespace kerf {

using gpu::TexelFormat;

Unfolding::Unfolding(const SolverBody& body)
    : forgetFolds_(body.compile("unfold/not_folded")),
      findFolds_(body.compile("unfold/folds")),
      findGoals_(body.compile("unfold/goals")),
      unfold_(body.compile("unfold/unfold")) {}

void Unfolding::resize(std::size_t vertices) {
    folds_.resize(vertices * sizeof(float));
    goals_.resize(vertices * sizeof(shared::UnfoldGoal));
}

void Unfolding::run(SolverBody& body) {
    bind(body);
    body.run(forgetFolds_, body.uniforms.vertex_count);
    body.run(findFolds_, body.uniforms.count[shared::kBend]);
    body.run(findGoals_, body.uniforms.vertex_count);
    body.run(unfold_, body.uniforms.vertex_count);
}

void Unfolding::bind(const SolverBody& body) const {
    const auto bindBoth = [&](const gpu::Buffer& buffer, shared::uint binding, TexelFormat format) {
        buffer.bindStorage(binding);
        body.bindFetched(buffer, binding, format);
    };
    body.bind();
    body.bindFetched(body.model.restPositions, shared::kUnfoldRestBinding, TexelFormat::float32x4);
    body.bindFetched(body.model.constraints[shared::kBend].records, shared::kUnfoldBendsBinding,
                     TexelFormat::uint32x4);
    body.bindFetched(body.model.neighbours.ranges, shared::kRangesBinding, TexelFormat::uint32x2);
    body.bindFetched(body.model.neighbours.entries, shared::kEntriesBinding, TexelFormat::uint32x2);
    bindBoth(folds_, shared::kUnfoldFoldsBinding, TexelFormat::uint32);
    bindBoth(goals_, shared::kUnfoldGoalsBinding, TexelFormat::float32x4);
}

}  // namespace kerf
