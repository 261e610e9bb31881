#pragma once

#include <vector>

#include "sim/base/params.h"
#include "sim/body/body_model.h"

namespace kerf {

/// Of so many steps a time step is made at most, however fast a splinter is.
inline constexpr int kMostImplicitSteps = 32;

/// The box of each member at rest; empty where none of it is left [m].
std::vector<Bounds> memberBoxes(const BodyModel& model);
/// longestImplicitStep() for all members of the body; infinite where nothing is left [s].
double longestStep(const BodyModel& model, const Params& params);
/// Of how many steps no longer than `longest` a time step is made [s]; kMostImplicitSteps at most.
int stepsWithin(double timeStep, double longest);
/// Of the smallest member at rest [m]; infinite where nothing is left.
double leastDiagonal(const BodyModel& model);
/// The longest step of a body that meets something at this speed [m/s]: beyond it rebounds err by
/// more than a tenth, and some gain energy. `diagonal`: leastDiagonal() [m]. [s]
double longestStepAt(double speed, double diagonal);
/// Iterations of a stage, where they are auto, of a body that meets something on `way` in a step,
/// in leastDiagonal(): what strikes, or lies on other pieces and moves, needs more, and a large
/// body by the root of its vertices. `error`: see Params::iterationError.
int implicitIterations(const BodyModel& model, double way, double error);
/// Of the energy of a motion, how much an error by that share leaves: see ImplicitStep::close.
double energyLeft(double error);

}  // namespace kerf
