#pragma once

#include <spdlog/fmt/fmt.h>

#include <string>
#include <utility>
#include <vector>

#include "sim/base/params.h"
#include "sim/contact/static_box.h"
#include "sim/cut/cut_types.h"
#include "sim/run/parts/led_blade.h"
#include "sim/run/parts/step_report.h"

namespace kerf {

/// What a person has set.
struct SimulationInput {
    Params params;
    bool paramsChanged = false;  ///< since the body was told of them
    std::vector<StaticBox> boxes;
    LedBlade blade;
    bool timeRuns = true;  ///< see SetTime
};

/// The time of a simulation.
struct SimulationClock {
    int stepsDone = 0;
    double time = 0;  ///< [s]
};

/// What a simulation tells.
struct SimulationOutput {
    SimulationClock clock;
    StepReport report;
    CutResult lastCut;                  ///< of the last step that the blade moved in
    std::vector<std::string> messages;  ///< since they were last taken
    std::string refusal;                ///< see Simulation::refusalOfStroke()
    bool toldTooLarge = false;          ///< for the undo memory, since a body last fit into it
    int bodyRevision = 0;               ///< see Simulation::bodyRevision()

    /// Tells a person a sentence about the step.
    template <class... Parts>
    void say(fmt::format_string<Parts...> format, Parts&&... parts) {
        messages.push_back(fmt::format("step {}: ", clock.stepsDone) +
                           fmt::format(format, std::forward<Parts>(parts)...));
    }
};

}  // namespace kerf
