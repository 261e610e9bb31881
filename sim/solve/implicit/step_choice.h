#pragma once

#include <vector>

#include "sim/base/params.h"
#include "sim/body/body_model.h"

namespace kerf {

/// The box of each member at rest; empty where none of it is left [m].
std::vector<Bounds> memberBoxes(const BodyModel& model);
/// The longest implicit step that errs by a few hundredths of a motion: less than a wave needs to
/// cross a member of the body, between 1/240 and 1/60 s. From measured swings, see
/// docs/notes/implicit-steps.md. [s]
double longestStep(const BodyModel& model, const Params& params);
/// Of how many steps no longer than `longest` a time step is made [s].
int stepsWithin(double timeStep, double longest);
/// The longest step of a body that meets something at this speed [m/s]: beyond it rebounds err by
/// more than a tenth, and some gain energy. `diagonal`: of the body [m]. [s]
double longestStepAt(double speed, double diagonal);
/// Iterations of a stage, where they are auto, of a body that meets something on `way` in a step
/// [m]: what strikes, or lies on other pieces and moves, needs more.
int implicitIterations(const BodyModel& model, double way);

}  // namespace kerf
