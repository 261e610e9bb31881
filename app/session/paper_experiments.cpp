#include "app/session/paper_experiments.h"

namespace kerf::app {

namespace {

constexpr std::array<PaperExperiment, 5> kExperiments{{
    {"sphere20", "Sphere 20", 0.005, 30, 20, 99.6, 172.1},
    {"sphere80", "Sphere 80", 0.005, 30, 80, 98.5, 166.1},
    {"sphere768", "Sphere 768", 0.005, 20, 768, 98.0, 160.5},
    {"octopus", "Octopus", 0.003, 20, 0, 91.1, 81.1},
    {"banana", "Banana", 0.003, 10, 0, 98.3, 51.8},
}};

}  // namespace

std::span<const PaperExperiment> paperExperiments() {
    return kExperiments;
}

const PaperExperiment* findPaperExperiment(std::string_view name) {
    const auto found = std::ranges::find_if(
        kExperiments, [name](const PaperExperiment& e) { return name == e.name; });
    return found == kExperiments.end() ? nullptr : &*found;
}

}  // namespace kerf::app
