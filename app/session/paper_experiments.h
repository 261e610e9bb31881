#pragma once

namespace kerf::app {

/// One of the paper's five experiments as described in the paper (docs/architecture.md, Sources).
/// Its tables 1 to 3 are known only as far as its text repeats them. The rest of it is in the
/// report of `kerf experiment` (bench/lab/paper.py).
struct PaperExperiment {
    const char* name;   ///< of the builtin model and of the session
    const char* label;  ///< as the paper writes it
    double timeStep;    ///< [s], section 3.1
    int iterations;     ///< section 3.1
    int triangles;      ///< before the cut, from the name of the model; 0 where not known
    double meanVolume;  ///< % of rest, section 3.2 on figure 10
    double meanFps;     ///< [1/s], section 3.2 on figure 9
};

/// The experiments in the paper's order.
std::span<const PaperExperiment> paperExperiments();
/// The experiment of a name; null for an unknown one.
const PaperExperiment* findPaperExperiment(std::string_view name);

}  // namespace kerf::app
