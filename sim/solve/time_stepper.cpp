#include "sim/solve/time_stepper.h"

#include <utility>

#include "sim/base/pausing.h"

namespace kerf {

using shared::uint;

namespace {

/// Nothing is bound from one such piece of work to the next.
template <class F>
void timed(gpu::ComputeTimer& timer, F&& work) {
    pausePoint();
    timer.begin();
    work();
    timer.end();
}

}  // namespace

void TimeStepper::setBody(const BodyModel& model, bool isNew) {
    smallBody_.setBody(model, body_.pieces.blocks(), isNew || body_.plainPbd());
    sweepsFaster_ = isNew ? FasterWay() : sweepsFaster_;
}

void TimeStepper::step(bool heldMove) {
    unfolds_ = unfolds() && mayUnfold_;
    const gpu::Buffer* folds = unfolds_ ? &unfolding_.folds() : nullptr;
    collisions_.beginStep(folds);
    phases_.setFolds(folds);
    smallBody_.setFolds(folds);
    solve(heldMove);
    if (collisions_.followsThePaper()) {
        timed(collideTimer_, [&] { collisions_.respondAsThePaper(); });
    }
}

void TimeStepper::solve(bool heldMove) {
    if (implicit_ != nullptr) {
        stepImplicitly(heldMove);
    } else if (sweepsInOneGroup() && smallBody_.large()) {
        stepTheFasterWay();
    } else if (sweepsInOneGroup()) {
        stepBySweeps();
    } else if (!solvesInOneGroup()) {
        stepByPhases();
    } else if (!collisions_.mayTouch() && !unfolds_) {
        stepAtOnce();
    } else if (touchingSubstepsAtOnce() > 0) {
        stepTouching();
    } else {
        stepBySubsteps();
    }
}

bool TimeStepper::solvesInOneGroup() const {
    const bool bySubsteps = oneGroupAllowed_ && body_.uniforms.sweeps == 1 && smallBody_.fits();
    return bySubsteps || (sweepsInOneGroup() && !smallBody_.large());
}

bool TimeStepper::sweepsInOneGroup() const {
    return oneGroupAllowed_ && body_.uniforms.sweeps > 1 && body_.plainPbd() &&
           !body_.active(shared::kVolumePart) && body_.uniforms.pull_count == 0 &&
           !collisions_.mayTouch() && smallBody_.sweepsAtOnce() > 0;
}

/// The cores of llvmpipe may be so far from each other that one of them is done sooner alone; their
/// compute shaders have run when a dispatch returns. Both ways give the same bits there. Another
/// driver may contract multiplications and additions otherwise in each: no clock chooses there.
void TimeStepper::stepTheFasterWay() {
    if (smallBody_.way() != gpu::KernelWay::images) {
        stepByPhases();
        return;
    }
    const WorkWatch watch;
    sweepsFaster_.next() == 0 ? stepBySweeps() : stepByPhases();
    sweepsFaster_.took(watch.seconds());
}

/// SubstepRun or SweepRun.
template <class Run>
void TimeStepper::runSmallBody(const Run& run) {
    timed(deformTimer_, [&] { smallBody_.run(body_, run); });
    ++body_.dispatches;
}

void TimeStepper::stepBySweeps() {
    const uint sweeps = body_.uniforms.sweeps;
    const uint atOnce = smallBody_.sweepsAtOnce();
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        for (uint first = 0; first < sweeps; first += atOnce) {
            runSmallBody(SweepRun{first, std::min(first + atOnce, sweeps)});
        }
    }
}

void TimeStepper::stepByPhases() {
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        if (searchBefore(i) && waitsForSearches_) {
            collisions_.countCandidates();
        }
        const bool settles =
            settlingAllowed_ && !collisions_.mayTouch() && body_.uniforms.pull_count == 0;
        unfoldBefore(i > 0);
        collisions_.beginSubstep();
        for (uint sweep = 0; sweep < body_.uniforms.sweeps; ++sweep) {
            const bool last = sweep + 1 == body_.uniforms.sweeps;
            const bool lifts = settles && !last && phases_.mayGatherOntoFloor();
            timed(deformTimer_,
                  [&] { sweep == 0 ? phases_.predictAndStretch() : phases_.stretchAgain(); });
            timed(deformTimer_, [&] { phases_.solveAll(lifts); });
            if (!(settles && last) && !lifts) {
                holdVolumeAndCollide(i, last);
            }
        }
        timed(deformTimer_, [&] { settles ? phases_.settle() : phases_.finish(); });
    }
}

/// The floor comes with the end of the substep in the last sweep.
void TimeStepper::holdVolumeAndCollide(uint substep, bool last) {
    timed(deformTimer_, [&] { phases_.solveVolume(); });
    timed(collideTimer_, [&] {
        phases_.pull();
        collisions_.respond(substep);
        if (!last) {
            phases_.collideFloor();
        }
    });
}

void TimeStepper::stepImplicitly(bool heldMove) {
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        searchBefore(i);
        unfoldBefore(false);
        collisions_.beginSubstep();
        implicit_->run(i, heldMove, [&](auto&& part) { timed(deformTimer_, part); });
    }
}

void TimeStepper::stepAtOnce() {
    for (uint done = 0; done < body_.uniforms.substeps; done += smallBody_.substepsAtOnce()) {
        const uint left = body_.uniforms.substeps - done;
        runSmallBody(SubstepRun{std::min(left, smallBody_.substepsAtOnce()), false, false});
    }
}

/// Whole substeps of a small body with all contact that may come, in a dispatch; 0: not so.
uint TimeStepper::touchingSubstepsAtOnce() const {
    return collisions_.answersInOneGroup()
               ? smallBody_.touchingSubstepsAtOnce(*collisions_.boxes().plainBoxes())
               : 0;
}

/// Contact is looked for between two dispatches.
void TimeStepper::stepTouching() {
    const uint atOnce = touchingSubstepsAtOnce();
    const uint end = body_.uniforms.substeps;
    for (uint i = 0; i < end;) {
        searchBefore(i);
        const uint first = i++;
        while (i < end && i - first < atOnce && !collisions_.searchesBefore(i)) {
            ++i;
        }
        timed(deformTimer_, [&] { smallBody_.run(body_, i - first, collisions_); });
        ++body_.dispatches;
    }
}

/// Contact and boxes act while a substep is open; contacts are looked for and folds unfolded
/// between two.
void TimeStepper::stepBySubsteps() {
    bool open = false;
    for (uint i = 0; i < body_.uniforms.substeps; ++i) {
        if ((unfolds_ || collisions_.searchesBefore(i)) && std::exchange(open, false)) {
            runSmallBody(SubstepRun{0, true, false});
        }
        searchBefore(i);
        unfoldBefore(false);
        runSmallBody(SubstepRun{1, open, true});
        open = true;
        timed(collideTimer_, [&] {
            collisions_.beginSubstep();
            collisions_.respond(i);
        });
    }
    runSmallBody(SubstepRun{0, true, false});
}

void TimeStepper::unfoldBefore(bool afterPhases) {
    if (unfolds_) {
        timed(deformTimer_, [&] { unfolding_.run(body_, afterPhases); });
    }
}

/// Whether it searched.
bool TimeStepper::searchBefore(uint substep) {
    const bool searches = collisions_.searchesBefore(substep);
    if (searches) {
        timed(collideTimer_, [&] { collisions_.search(); });
    }
    return searches;
}

}  // namespace kerf
