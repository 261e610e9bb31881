#pragma once

#include <string>
#include <variant>

#include "sim/cut/blade.h"
#include "sim/params.h"

namespace kerf {

/// Everything that changes a simulation is a command, applied before a step: mouse, panels and
/// session files all push the same ones, so a recording replays by construction.

/// Moves the blade here during the coming step; the first one after the start or a lift places it
/// without cutting.
struct MoveBlade {
    Blade blade;
};
/// Takes the blade away.
struct LiftBlade {};
/// Changes one parameter.
struct SetParam {
    std::string name;
    ParamValue value;
};

using Command = std::variant<MoveBlade, LiftBlade, SetParam>;

}  // namespace kerf
