#include "app/session/real_time_factor.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/base/quantity_text.h"
#include "sim/run/simulation.h"

namespace kerf::app {

std::optional<double> realTimeFactor(double simulatedSeconds, double milliseconds) {
    const bool passed = simulatedSeconds > 0 && milliseconds > 0;
    return passed ? std::optional(1000 * simulatedSeconds / milliseconds) : std::nullopt;
}

double secondsOfStep(const Simulation& simulation) {
    return simulation.timeRuns() ? simulation.params().timeStep : 0;
}

void RealTimeFactors::add(double simulatedSeconds, double stepMs, double pictureMs) {
    if (const std::optional<double> factor = realTimeFactor(simulatedSeconds, stepMs)) {
        simulated_ += simulatedSeconds;
        stepMs_ += stepMs;
        pictureMs_ += pictureMs;
        ofSteps_.push_back(*factor);
    }
}

std::optional<double> RealTimeFactors::median() const {
    std::vector<double> factors = ofSteps_;
    const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
    std::nth_element(factors.begin(), middle, factors.end());
    return factors.empty() ? std::nullopt : std::optional(*middle);
}

std::optional<double> RealTimeFactors::worst() const {
    return ofSteps_.empty() ? std::nullopt : std::optional(*std::ranges::min_element(ofSteps_));
}

std::optional<double> RealTimeFactors::withDrawing() const {
    return realTimeFactor(simulated_, stepMs_ + pictureMs_);
}

std::string RealTimeFactors::sentence() const {
    const std::optional<double> all = realTimeFactor(simulated_, stepMs_);
    if (!all) {
        return "none was simulated";
    }
    const std::string pictures =
        pictureMs_ > 0 ? ", " + factorText(*withDrawing()) + " with pictures" : "";
    return fmt::format("{:.3g} s simulated in {:.3g} s, {} real time (slowest step {}){}",
                       simulated_, stepMs_ / 1000, factorText(*all), factorText(*worst()),
                       pictures);
}

nlohmann::ordered_json toJson(const RealTimeFactors& factors) {
    using Json = nlohmann::ordered_json;
    const auto orNull = [](const std::optional<double>& x) { return x ? Json(*x) : Json(); };
    return {{"median", orNull(factors.median())},
            {"worst", orNull(factors.worst())},
            {"with_drawing", orNull(factors.withDrawing())}};
}

}  // namespace kerf::app
