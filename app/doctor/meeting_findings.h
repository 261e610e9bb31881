#pragma once

#include <vector>

#include "app/doctor/finding.h"

namespace kerf::app {

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
