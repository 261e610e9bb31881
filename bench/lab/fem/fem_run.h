#pragma once

#include <filesystem>
#include <string>

#include "app/files/io/output_folder.h"
#include "bench/lab/fem/fem_case.h"
#include "bench/lab/fem/loaded_surface.h"

namespace kerf::app {

/// A choice of parameters that Kerf runs the cases with.
struct FemSetting {
    std::string name;   ///< of its files: "20"
    std::string label;  ///< for people: "20 iterations"
    void (*apply)(Params&) = nullptr;
};

/// Kerf's body at rest under its load.
struct KerfRun {
    LoadedSurface surface;
    bool settled = false;   ///< false where it still moved when time was up
    int steps = 0;          ///< of the session
    std::string stateHash;  ///< behind them
    std::string tooFew;     ///< the sentence on too few iterations; empty where there are enough
};

/// The file of the session of a case, in the folder of the experiment.
std::string sessionFile(const FemCase& each, const FemSetting& setting);

/// Runs the session of a case until the body rests, and writes model and session into `folder`, to
/// be replayed. Runs on the GL context that is current. Throws InputError where the session can't
/// be carried out, OutputError.
KerfRun runKerf(const FemCase& each, const FemSetting& setting, OutputFolder& folder);

/// What the finite elements of a case do.
LoadedSurface relaxedSurface(const FemCase& each, const SolidProblem& problem);

}  // namespace kerf::app
