#pragma once

#include "app/doctor/findings.h"
#include "app/session/real_time_factor.h"
#include "gpu/context.h"
#include "render/scene/image.h"

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

/// The findings about the driver of this machine.
struct Diagnosis {
    gpu::DeviceInfo device;
    std::vector<gpu::DriverLimit> limits;
    std::vector<DriverFinding> findings;
    std::vector<ModelSpeed> speeds;  ///< none in a quick examination
    render::Image picture;           ///< of the cut body, drawn by this driver
    int debugErrors = 0;             ///< reported by OpenGL
    double seconds = 0;

    /// Whether all checks hold.
    bool right() const;
    /// The result and what to do, in a sentence or two.
    std::string verdict() const;
};

/// The extent of an examination.
struct Examination {
    bool speeds = true;
    double secondsEach = 8;  ///< of a model's speed
    /// Called with the name of the next part; may be null.
    std::function<void(const std::string& part)> next = nullptr;
};

/// Examines the driver of the current context: its limits, short sessions, a cut and its
/// repetition, a picture, the order of writes and reads, forms of kernels, and the speed of the
/// paper's models. Exceptions, as of a shader that does not compile, are findings. Throws
/// InputError if the builtin models are missing.
Diagnosis diagnose(const Examination& examination = {});

}  // namespace kerf::app
