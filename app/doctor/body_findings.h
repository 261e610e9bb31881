#pragma once

#include <string>
#include <vector>

#include "app/doctor/finding.h"
#include "app/session/session.h"
#include "render/scene/image.h"

namespace kerf::app {

/// A body that falls freely must gain what gravity gives it, and keep its volume: first with one
/// substep a step, then with twenty, since drivers are known that keep the number of before.
std::vector<DriverFinding> freeFallFindings();

/// A body that is dropped must lie still on the floor a while later, with all of its volume.
std::vector<DriverFinding> restFindings();

/// What a played session must end in.
struct CutRun {
    std::string stateHash;
    int pieces = 0;
    double volumeRatio = 0;  ///< against rest
    bool closed = true;      ///< after every step
    render::Image picture;   ///< of the end
};

/// Plays a session and takes a picture of its end. Throws as Simulation does, and InputError.
CutRun playCut(const Session& session);

/// A body that is cut and falls, played twice: it must part, stay closed, keep its volume, and end
/// in the same bits. `picture` is that of the end.
struct CutFindings {
    std::vector<DriverFinding> findings;
    render::Image picture;
};
CutFindings cutFindings();

}  // namespace kerf::app
