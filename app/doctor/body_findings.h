#pragma once

#include <string>
#include <vector>

#include "app/doctor/finding.h"
#include "render/scene/image.h"

namespace kerf::app {

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

}  // namespace kerf::app
