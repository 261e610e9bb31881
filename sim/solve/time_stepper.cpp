#include "sim/solve/time_stepper.h"

#include "gpu/prompt_waits.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/body_records.h"
#include "shaders/shared/unfold_records.h"
#include "sim/base/pausing.h"

namespace kerf {

using gpu::TexelFormat;
using shared::uint;

namespace {

using gpu::Defines;
using gpu::TexelFormat;
using shared::uint;

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

/// A kernel for each type but edges.
std::array<gpu::Program, kConstraintTypes> compileForEach(const SolverBody& body,
                                                          const std::string& name) {
    std::array<gpu::Program, kConstraintTypes> kernels;
    for (uint type = 1; type < kConstraintTypes; ++type) {
        kernels[type] = body.compile(name, kNames[type]);
    }
    return kernels;
}

}  // namespace

SweepPhases::SweepPhases(SolverBody& body)
    : body_(body),
      stretch_(body.compile("stretch")),
      stretchAgain_(body.compile("stretch", {{"SWEEP_AGAIN", "1"}})),
      solve_(compileForEach(body, "constraint")),
      gather_(compileForEach(body, "gather_corrections")),
      pull_(gpu::Program::compute("sim/pull.comp")),
      floor_(body.compile("floor")),
      finish_(body.compile("finish")) {}

void SweepPhases::predictAndStretch() {
    body_.bind();
    bindLists(shared::kStretch);
    body_.run(stretch_, body_.uniforms.vertex_count);
}

void SweepPhases::stretchAgain() {
    std::swap(body_.state.displacement, body_.state.previous);
    body_.bind();
    body_.bindFetched(body_.state.previous, shared::kPreviousBinding, TexelFormat::float32x4);
    bindLists(shared::kStretch);
    body_.run(stretchAgain_, body_.uniforms.vertex_count);
}

void SweepPhases::bindLists(uint type) const {
    const ConstraintBuffers& buffers = body_.model.constraints[type];
    body_.bindFetched(buffers.ranges, shared::kRangesBinding, buffers.rangeTexels);
    body_.bindFetched(buffers.entries, shared::kEntriesBinding, buffers.entryTexels);
}

void SweepPhases::solve(uint type) {
    if (!body_.active(1u << type)) {
        return;
    }
    body_.bind();
    body_.bindFetched(body_.model.constraints[type].records, shared::kConstraintsBinding,
                      TexelFormat::uint32x4);
    const gpu::Buffer& corrections = body_.state.corrections;
    corrections.bindStorage(shared::kCorrectionsBinding);
    body_.bindFetched(corrections, shared::kCorrectionsBinding, TexelFormat::float32x4);
    body_.run(solve_[type], body_.uniforms.count[type]);
    bindLists(type);
    body_.run(gather_[type], body_.uniforms.vertex_count);
}

void SweepPhases::pull() {
    if (body_.uniforms.pull_count > 0) {
        body_.bind();
        body_.pulls.bindStorage(shared::kPullsBinding);
        body_.run(pull_, body_.uniforms.pull_count);
    }
}

void SweepPhases::collideFloor() {
    if (body_.active(shared::kFloorPart)) {
        body_.bind();
        body_.run(floor_, body_.uniforms.vertex_count);
    }
}

void SweepPhases::finish() {
    body_.bind();
    body_.run(finish_, body_.uniforms.vertex_count);
}

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

/// Nothing is bound from one such piece of work to the next.
template <class F>
void TimeStepper::timed(gpu::ComputeTimer& timer, F&& work) {
    pausePoint();
    const gpu::PromptWaits prompt(onProcessors_);
    timer.begin();
    work();
    timer.end();
}

void TimeStepper::step(bool heldMove) {
    const bool folded = implicit_ != nullptr && mayUnfold_ && unfolds();
    collisions_.beginStep(folded ? &unfolding_.folds() : nullptr);
    if (implicit_ != nullptr) {
        stepImplicitly(heldMove);
    } else {
        sweep();
    }
    if (collisions_.followsThePaper()) {
        timed(collideTimer_, [&] { collisions_.respondAsThePaper(); });
    }
}

void TimeStepper::stepImplicitly(bool heldMove) {
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        searchBefore(i);
        if (collisions_.contacts().folds() != nullptr) {
            timed(deformTimer_, [&] { unfold(); });
        }
        collisions_.beginSubstep();
        implicit_->run(i, heldMove, [&](auto&& part) { timed(deformTimer_, part); });
    }
}

void TimeStepper::sweep() {
    searchBefore(0);
    collisions_.beginSubstep();
    for (uint sweep = 0; sweep < body_.uniforms.sweeps; ++sweep) {
        timed(deformTimer_,
              [&] { sweep == 0 ? phases_.predictAndStretch() : phases_.stretchAgain(); });
        timed(deformTimer_, [&] {
            for (uint type = 1; type < kConstraintTypes; ++type) {
                phases_.solve(type);
            }
        });
        collide(sweep + 1 == body_.uniforms.sweeps);
    }
    timed(deformTimer_, [&] { phases_.finish(); });
}

/// The floor comes with the end of the step in the last sweep.
void TimeStepper::collide(bool last) {
    timed(collideTimer_, [&] {
        phases_.pull();
        collisions_.respond();
        if (!last) {
            phases_.collideFloor();
        }
    });
}

void TimeStepper::searchBefore(uint substep) {
    if (collisions_.searchesBefore(substep)) {
        timed(collideTimer_, [&] { collisions_.search(); });
    }
}

}  // namespace kerf
