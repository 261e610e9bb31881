#pragma once

#include <vector>

#include "app/doctor/finding.h"

namespace kerf::app {

/// What a body meets must hold it: a half that was cut off lies on the other one, a body lies on a
/// box, a hand holds it, and what is pinned stays where it is. Throws gpu::ShaderError,
/// gpu::OutOfMemory, InputError where the builtin models are missing.
std::vector<DriverFinding> meetingFindings();

}  // namespace kerf::app
