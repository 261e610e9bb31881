#pragma once

#include <string>
#include <vector>

#include "render/scene/image.h"

namespace kerf::app {

/// The result of one check of a driver.
struct DriverFinding {
    std::string check;  ///< "Free fall"
    std::string seen;   ///< the measured value, with its unit
    std::string asked;  ///< the value with a working driver
    bool right = false;
};

/// Compares each kernel of the solver, and a whole step, with what the double-precision reference
/// answered (recorded_answers.h), on builtin models that are perturbed and in motion. Throws
/// gpu::ShaderError, gpu::OutOfMemory, InputError if the builtin models or answers are missing.
std::vector<DriverFinding> kernelFindings(const std::vector<std::string>& models = {
                                              "sphere20", "sphere768", "banana"});

/// A body in free fall must accelerate by gravity, and keep its volume: first with one substep a
/// step, then with twenty, since some drivers keep the previous number.
std::vector<DriverFinding> freeFallFindings();

/// A dropped body must come to rest on the floor, with all of its volume.
std::vector<DriverFinding> restFindings();

/// A body that is cut and falls, played twice: it must separate, stay closed, keep its volume, and
/// end with the same bits. `picture` shows the end.
struct CutFindings {
    std::vector<DriverFinding> findings;
    render::Image picture;
};
CutFindings cutFindings();

/// A body is cut across under its weight: the upper half must rest on the lower one, and that on
/// the floor. Throws like meetingFindings().
DriverFinding halvesFinding();
/// A body that falls a little onto a box must rest on it. Throws like meetingFindings().
DriverFinding boxFinding();
/// A hand must hold a body by its top. Throws like meetingFindings().
DriverFinding handFinding();

/// Contact checks: a cut-off half rests on the other one, a body rests on a box, a hand holds it,
/// and pinned vertices stay. Throws gpu::ShaderError, gpu::OutOfMemory, InputError if the builtin
/// models are missing.
std::vector<DriverFinding> meetingFindings();

}  // namespace kerf::app
