#pragma once

#include <spdlog/fmt/fmt.h>

#include "sim/base/params.h"
#include "sim/contact/static_box.h"
#include "sim/cut/cut_types.h"
#include "sim/run/parts/led_blade.h"
#include "sim/run/parts/step_report.h"

namespace kerf {

/// The input of a person.
struct SimulationInput {
    Params params;
    bool paramsChanged = false;  ///< since the body got them
    int iterations = 0;          ///< of the coming step: those of the parameters, or chosen
    int implicitSteps = 1;       ///< of the coming step: see Params
    std::vector<StaticBox> boxes;
    LedBlade blade;
    bool timeRuns = true;  ///< see SetTime

    /// The parameters with the number of iterations and implicit steps of the coming step.
    Params solved() const {
        Params numbers = params;
        numbers.iterations = iterations;
        numbers.implicitSteps = implicitSteps;
        return numbers;
    }
};

/// The time of a simulation.
struct SimulationClock {
    int stepsDone = 0;
    double time = 0;  ///< [s]
};

/// The output of a simulation.
struct SimulationOutput {
    SimulationClock clock;
    StepReport report;
    CutResult lastCut;                  ///< of the last step with blade motion
    std::vector<std::string> messages;  ///< since they were last taken
    std::string refusal;                ///< see Simulation::refusalOfStroke()
    bool toldTooLarge = false;          ///< for the undo memory, since a body last fitted
    int bodyRevision = 0;               ///< see Simulation::bodyRevision()

    /// Adds a message about the step.
    template <class... Parts>
    void say(fmt::format_string<Parts...> format, Parts&&... parts) {
        messages.push_back(fmt::format("step {}: ", clock.stepsDone) +
                           fmt::format(format, std::forward<Parts>(parts)...));
    }
};

}  // namespace kerf
