#pragma once

#include <string>
#include <vector>

#include "render/scene/image.h"

namespace kerf::app {

/// What one check of a driver found.
struct DriverFinding {
    std::string check;  ///< "Free fall"
    std::string seen;   ///< what was measured, with its unit
    std::string asked;  ///< what a driver that works gives
    bool right = false;
};

/// Compares each kernel of the solver, and a whole step, with the same in double precision, on
/// builtin models that are shaken and in motion. Throws gpu::ShaderError, gpu::OutOfMemory,
/// InputError where the builtin models are missing.
std::vector<DriverFinding> kernelFindings(const std::vector<std::string>& models = {
                                              "sphere20", "sphere768", "banana"});

/// A body that falls freely must gain what gravity gives it, and keep its volume: first with one
/// substep a step, then with twenty, since drivers are known that keep the number of before.
std::vector<DriverFinding> freeFallFindings();

/// A body that is dropped must lie still on the floor a while later, with all of its volume.
std::vector<DriverFinding> restFindings();

/// A body that is cut and falls, played twice: it must part, stay closed, keep its volume, and end
/// in the same bits. `picture` is that of the end.
struct CutFindings {
    std::vector<DriverFinding> findings;
    render::Image picture;
};
CutFindings cutFindings();

/// A body is cut across under its weight: the upper half must lie on the lower one, and that on the
/// floor. Throws as meetingFindings().
DriverFinding halvesFinding();
/// A body that falls a little onto a box must lie on it. Throws as meetingFindings().
DriverFinding boxFinding();
/// A hand must hold a body by its top. Throws as meetingFindings().
DriverFinding handFinding();

/// What a body meets must hold it: a half that was cut off lies on the other one, a body lies on a
/// box, a hand holds it, and what is pinned stays where it is. Throws gpu::ShaderError,
/// gpu::OutOfMemory, InputError where the builtin models are missing.
std::vector<DriverFinding> meetingFindings();

}  // namespace kerf::app
