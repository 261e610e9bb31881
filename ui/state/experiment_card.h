#pragma once

#include <optional>
#include <string>

#include "ui/plots/history.h"

namespace kerf::ui {

/// One of the paper's experiments: its figures beside ours.
struct ExperimentCard {
    std::string name;     ///< "sphere768", for OpenExperiment
    std::string label;    ///< "Sphere 768"
    double timeStep = 0;  ///< the paper's [s]
    int iterations = 0;   ///< the paper's
    int triangles = 0;    ///< the paper's, before the cut; 0 if unknown
    RunFigures paper;
    std::optional<RunFigures> ours;  ///< of the run that is open, or of the last one; none without
    int ourTriangles = 0;            ///< of that run, at present
    bool open = false;
};

}  // namespace kerf::ui
