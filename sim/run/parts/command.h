#pragma once

#include "sim/base/params.h"
#include "sim/base/placement.h"
#include "sim/contact/static_box.h"
#include "sim/cut/blade.h"

namespace kerf {

/// Everything that changes a simulation is a command, applied before a step: mouse, panels and
/// session files all push the same ones, so a recording replays by construction.

/// Moves the blade to a pose during the coming step; the first pose after the start or a lift
/// places it without cutting.
struct MoveBlade {
    Blade blade;
    /// How long a person took for a step to this pose [s], while paused; films show it that long.
    /// It does not affect the simulation.
    std::optional<double> seconds = std::nullopt;
};
/// Removes the blade.
struct LiftBlade {};
/// Changes one parameter.
struct SetParam {
    std::string name;
    ParamValue value;
    /// Part of the gesture of the previous change of this parameter: one undo reverts both.
    bool continues = false;
    /// The label of its material; empty for none. Parameters that one material sets in a row are
    /// one change.
    std::string material = {};
};
/// A hand grabs, by springs, all vertices that are now within `radius` of `at`. Hands have numbers;
/// one that holds something releases it.
struct Grab {
    int hand = 0;
    Vec3 at = Vec3::Zero();
    double radius = 0;  ///< [m]
    /// Within the radius along the surface, and on one side of a cut: see surfacePatch().
    bool alongSurface = false;
    /// Part of the gesture of the previous grab: one undo reverts both.
    bool continues = false;
};
/// Moves a hand to a point during the coming step, with what it holds.
struct Drag {
    int hand = 0;
    Vec3 to = Vec3::Zero();
};
/// Releases what a hand holds.
struct Release {
    int hand = 0;
};
/// Pins the vertices that are now in the region: they are fixed, or move as prescribed, until
/// unpinned.
struct Pin {
    Region region;
    bool pinned = true;  ///< false unpins those in the region
    /// Part of the gesture of the previous pin: one undo reverts both.
    bool continues = false;
    std::optional<Vec3> velocity = std::nullopt;   ///< with which they move [m/s]
    std::optional<double> seconds = std::nullopt;  ///< for how long, if not for good [s]
};
/// A force on the vertices that are now in the region, shared by mass: it acts until it is taken
/// away, by a force of 0.
struct ApplyForce {
    Region region;
    Vec3 newtons = Vec3::Zero();  ///< on all of them together
    /// Part of the gesture of the previous force, whose region grows: one undo reverts both.
    bool continues = false;
};
/// Turns the pinned vertices about their middle and moves them, at once; they are at rest then.
struct MovePins {
    Vec3 by = Vec3::Zero();      ///< [m]
    Vec3 rotate = Vec3::Zero();  ///< about the world's x, then y, then z axis [degrees]
    /// Part of the gesture of the previous move: one undo reverts both.
    bool continues = false;
};
/// Appends a box.
struct AddBox {
    StaticBox box;
};
/// Moves or changes the box of this number, from 0; what is in its new place is pushed out.
struct ChangeBox {
    int index = 0;
    StaticBox box;
    /// Part of the gesture of the previous change of this box: one undo reverts both.
    bool continues = false;
};
/// Removes the box of this number; those behind it move up.
struct RemoveBox {
    int index = 0;
};
/// Removes the piece of this number, from 0 in the order in which they came off, with what holds or
/// pulls it. Those behind it move up. Not the last piece, and not during a stroke.
struct RemovePiece {
    int piece = 0;
};
/// Restores the uncut body at rest; parameters, boxes and time stay.
struct Restart {};
/// Restart, with a new placement of a model: unit, rotation, scale, position. Parameters that
/// suited the size of the largest model follow (see followSize()).
struct Place {
    Placement placement;
    /// Part of the gesture of the previous placement: one undo reverts both.
    bool continues = false;
    int model = 0;  ///< of the scene, by number
};
/// Undoes the last change: a cut, a grab or a removed piece (with all later motion of the body), a
/// restart, a placement, a parameter, pins or a box. A blade in the body is lifted first; time goes
/// on.
struct Undo {};
/// Redoes the last undone change.
struct Redo {};
/// Runs time, as at the start, or pauses it. While paused, steps only move the blade: it cuts the
/// body in its present position, no time passes, and a step costs no more than its cut.
struct SetTime {
    bool runs = true;
};

using Command =
    std::variant<MoveBlade, LiftBlade, SetParam, Grab, Drag, Release, Pin, MovePins, ApplyForce,
                 AddBox, ChangeBox, RemoveBox, RemovePiece, Restart, Place, Undo, Redo, SetTime>;

}  // namespace kerf
