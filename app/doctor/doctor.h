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

/// What the doctor found of the driver of this machine.
struct Diagnosis {
    gpu::DeviceInfo device;
    std::vector<gpu::DriverLimit> limits;
    std::vector<DriverFinding> findings;
    std::vector<ModelSpeed> speeds;  ///< none of a quick examination
    render::Image picture;           ///< of the cut body, as this driver draws it
    int debugErrors = 0;             ///< that OpenGL told of on the way
    double seconds = 0;

    /// Whether all is as it should be.
    bool right() const;
    /// What came of it and what to do, in a sentence or two.
    std::string verdict() const;
};

/// How thoroughly the doctor looks.
struct Examination {
    bool speeds = true;
    double secondsEach = 8;  ///< of a model's speed
    /// Called with the name of what comes next; may be null.
    std::function<void(const std::string& part)> next = nullptr;
};

/// Examines the driver of the context that is current: its limits, each kernel against the same in
/// double precision, free fall, rest, what a body meets, a cut and the same again, a picture, and
/// how fast the paper's models run. What throws there, such as a shader that does not compile, is a
/// finding. Throws InputError where the builtin models are missing.
Diagnosis diagnose(const Examination& examination = {});

}  // namespace kerf::app
