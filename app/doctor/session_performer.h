#pragma once

#include <string>

#include "app/files/model_source.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// Performs what a session says of the body, and passes over its pictures, exports and checks: a
/// host of SessionRunner::applyActions.
struct SessionPerformer {
    Simulation& simulation;

    /// Throws InputError where the command can't be performed.
    void perform(const Command& command, int /*event*/) const {
        const std::string problem = simulation.execute(command);
        if (!problem.empty()) {
            throw InputError(problem);
        }
    }
    template <class Event>
    void take(const Event& /*event*/) const {}
};

}  // namespace kerf::app
