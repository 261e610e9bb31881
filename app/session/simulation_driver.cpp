#include "app/session/simulation_driver.h"

#include "sim/mesh/invariants.h"

namespace kerf::app {

const StepReport& SimulationDriver::step() {
    const StepReport& report = simulation_.step();
    if (const std::optional<Blade> blade = simulation_.blade()) {
        strokePoses_.push_back(*blade);
    } else {
        strokePoses_.clear();
    }
    return report;
}

void SimulationDriver::goTo(const State& state) {
    simulation_.goTo(state.checkpoint);
    strokePoses_ = state.strokePoses;
}

CheckDifference SimulationDriver::compare(const CheckEvent& check) const {
    CheckDifference difference;
    std::string hash = check.hash ? simulation_.stateHash() : "";
    if (check.hash && hash != *check.hash) {
        difference.hash = std::move(hash);
    }
    // Found anew in the mesh, so that a check holds the counts of the report too.
    const int pieces = check.pieces ? static_cast<int>(simulation_.pieces().pieces.size()) : 0;
    if (check.pieces && pieces != *check.pieces) {
        difference.pieces = pieces;
    }
    return difference;
}

std::vector<std::string> SimulationDriver::newlyBroken(const StepReport& report) {
    std::vector<std::string> broken;
    if (!report.closed && !report.open && !std::exchange(toldOpen_, true)) {
        broken.emplace_back("the mesh is no closed, oriented 2-manifold any more");
    }
    if (!std::isfinite(report.volume) && !std::exchange(toldNotFinite_, true)) {
        broken.emplace_back("the volume is not finite any more");
    }
    return broken;
}

}  // namespace kerf::app
