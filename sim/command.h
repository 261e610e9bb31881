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
    /// Of the same gesture as the change of this parameter just before: one undo takes both back.
    bool continues = false;
};
/// Brings back the uncut body at rest; the parameters and the time go on.
struct Restart {};
/// Takes back the last change that is not undone: a cut (with all that the body did since), a
/// restart or a parameter. A blade that is in the body is lifted first; time goes on.
struct Undo {};
/// Brings back what the last undo took.
struct Redo {};

using Command = std::variant<MoveBlade, LiftBlade, SetParam, Restart, Undo, Redo>;

}  // namespace kerf
