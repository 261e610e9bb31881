#pragma once

#include <filesystem>

#include "bench/lab/experiment/experiment_result.h"

namespace kerf::app {

/// How experiments are run.
struct ExperimentPlan {
    std::filesystem::path out;  ///< folder of the report
    bool published = false;     ///< with the paper's solver, contact and course of the cut
    int runs = 5;               ///< of each stroke, for the spread of frame rates
};

/// Runs an experiment: once as a whole, into the folder of its name, then its stroke alone as often
/// as the plan says, into `runs` there, and with the other ways to find triangles, into `search`.
/// As published, also with lips drawn apart, into `hollow`. One run comes after the other, so that
/// none disturbs the times of another. Throws what replaySession throws.
ExperimentResult runExperiment(const PaperExperiment& experiment, const ExperimentPlan& plan);

/// Runs the experiment of figure 2, without and with ISPCs, into the folder `figure-2`.
Figure2 runFigure2(const ExperimentPlan& plan);

}  // namespace kerf::app
