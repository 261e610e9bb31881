#pragma once

#include <string>
#include <vector>

#include "app/doctor/finding.h"

namespace kerf::app {

/// Compares each kernel of the solver, and a whole step, with the same in double precision, on
/// builtin models that are shaken and in motion. Throws gpu::ShaderError, gpu::OutOfMemory,
/// InputError where the builtin models are missing.
std::vector<DriverFinding> kernelFindings(const std::vector<std::string>& models = {
                                              "sphere20", "sphere768", "banana"});

}  // namespace kerf::app
