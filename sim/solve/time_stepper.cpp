#include "sim/solve/time_stepper.h"

#include "gpu/prompt_waits.h"
#include "sim/base/pausing.h"

namespace kerf {

using shared::uint;

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
