#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/doctor/findings.h"
#include "app/doctor/model_speed.h"
#include "gpu/context.h"
#include "gpu/limits.h"
#include "render/scene/image.h"

namespace kerf::app {

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

/// Examines the driver of the current context: its limits, the order of writes and reads, forms of
/// kernels, short sessions, a cut and its repetition, a picture, and the speed of the paper's
/// models. Exceptions, as of a shader that does not compile,
/// are findings. Throws InputError if the builtin models are missing.
Diagnosis diagnose(const Examination& examination = {});

}  // namespace kerf::app
