#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kerf::app {

/// How the paper speaks of a volume that hardly changes.
inline constexpr const char* kNegligibleChange = "negligible change";

/// One of the paper's five experiments as the paper (docs/architecture.md, Sources) tells of it.
/// Its tables 1 to 3 are only known to us as far as its text repeats them.
struct PaperExperiment {
    const char* name;         ///< of the builtin model and of the session
    const char* label;        ///< as the paper writes it
    double timeStep;          ///< [s], section 3.1
    int iterations;           ///< section 3.1
    int triangles;            ///< before the cut, from the name of the model; 0 where not known
    double meanVolume;        ///< % of rest, section 3.2 on figure 10
    double meanFps;           ///< [1/s], section 3.2 on figure 9
    double gain;              ///< over the previous method [%], section 3.3; 0 where not given
    const char* volumeAfter;  ///< how the volume recovers, section 3.2 on figure 10

    /// Frames per second of the paper's previous method, as its gain says; nothing where that is
    /// not given.
    std::optional<double> previousFps() const;
};

/// The experiments in the paper's order.
std::span<const PaperExperiment> paperExperiments();
/// The experiment of a name; null for an unknown one.
const PaperExperiment* findPaperExperiment(std::string_view name);

}  // namespace kerf::app
