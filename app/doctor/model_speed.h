#pragma once

#include <string>
#include <vector>

namespace kerf::app {

/// How fast a recorded cut runs, each step with its picture.
struct ModelSpeed {
    std::string model;
    int frames = 0;         ///< that were timed
    double medianMs = 0;    ///< of a frame
    double worstCutMs = 0;  ///< the longest frame while the blade was down; 0 where it never was
    double framesPerSecond() const { return medianMs > 0 ? 1000 / medianMs : 0; }
};

/// Plays the recorded cut of each of the paper's models, a picture of 1280x720 a step, for so many
/// seconds each at most. The first frames, in which drivers compile, are left out. Throws as
/// Simulation does, and InputError.
std::vector<ModelSpeed> modelSpeeds(double secondsEach);

}  // namespace kerf::app
