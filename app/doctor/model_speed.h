#pragma once

#include <string>
#include <vector>

#include "app/session/real_time_factor.h"

namespace kerf::app {

/// The speed of a recorded cut, with a picture each step.
struct ModelSpeed {
    std::string model;
    int frames = 0;              ///< that were measured
    double medianMs = 0;         ///< of a frame
    double worstCutMs = 0;       ///< the longest frame while the blade was down; 0 if it never was
    RealTimeFactors realTime{};  ///< of these frames
    double framesPerSecond() const { return medianMs > 0 ? 1000 / medianMs : 0; }
};

/// Plays the recorded cut of each of the paper's models, with a picture of 1280x720 a step, for at
/// most `secondsEach`. The first frames, in which drivers compile, are omitted. Throws like
/// Simulation, and InputError.
std::vector<ModelSpeed> modelSpeeds(double secondsEach);

}  // namespace kerf::app
