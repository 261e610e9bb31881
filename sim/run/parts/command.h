#pragma once

#include <optional>
#include <string>
#include <variant>

#include "sim/base/params.h"
#include "sim/base/placement.h"
#include "sim/base/region.h"
#include "sim/contact/static_box.h"
#include "sim/cut/blade.h"

namespace kerf {

/// Everything that changes a simulation is a command, applied before a step: mouse, panels and
/// session files all push the same ones, so a recording replays by construction.

/// Moves the blade to a pose during the coming step; the first pose after the start or a lift
/// places it without cutting.
struct MoveBlade {
    Blade blade;
    /// How long a hand took for a step of the way there [s], where time stood: so long films show
    /// it. It changes no simulation.
    std::optional<double> seconds = std::nullopt;
};
/// Takes the blade away.
struct LiftBlade {};
/// Changes one parameter.
struct SetParam {
    std::string name;
    ParamValue value;
    /// Belongs to the gesture of the change of this parameter just before: one undo takes both
    /// back.
    bool continues = false;
    /// The label of the material that it belongs to; empty for none. Parameters that one material
    /// sets in a row are one change.
    std::string material = {};
};
/// A hand takes hold, by springs, of all vertices that are now within `radius` of `at`. Hands are
/// told apart by number; one that held something lets go of it.
struct Grab {
    int hand = 0;
    Vec3 at = Vec3::Zero();
    double radius = 0;  ///< [m]
    /// Within the radius along the surface, and on one side of a cut: see surfacePatch().
    bool alongSurface = false;
    /// Belongs to the gesture of the grab just before: one undo takes both back.
    bool continues = false;
};
/// Moves a hand to a point during the coming step, and what it holds along.
struct Drag {
    int hand = 0;
    Vec3 to = Vec3::Zero();
};
/// A hand lets go.
struct Release {
    int hand = 0;
};
/// Pins the vertices that are now in the region: they stay where they are, until freed.
struct Pin {
    Region region;
    bool pinned = true;  ///< false frees those in the region
    /// Belongs to the gesture of the pin just before: one undo takes both back.
    bool continues = false;
};
/// Turns what is pinned about its middle and moves it, at once; it is at rest then.
struct MovePins {
    Vec3 by = Vec3::Zero();      ///< [m]
    Vec3 rotate = Vec3::Zero();  ///< about the world's x, then y, then z axis [degrees]
    /// Belongs to the gesture of the move just before: one undo takes both back.
    bool continues = false;
};
/// Puts up a box, behind those there are.
struct AddBox {
    StaticBox box;
};
/// Puts the box of this number, from 0, elsewhere or makes it another; what lies in its new place
/// is pushed out.
struct ChangeBox {
    int index = 0;
    StaticBox box;
    /// Belongs to the gesture of the change of this box just before: one undo takes both back.
    bool continues = false;
};
/// Takes the box of this number away; those behind it move up.
struct RemoveBox {
    int index = 0;
};
/// Brings back the uncut body at rest; parameters, boxes and the time go on.
struct Restart {};
/// Restart, with a model placed otherwise: in another unit, turned, scaled, moved. Parameters that
/// suited the size of the largest model follow (see followSize()).
struct Place {
    Placement placement;
    /// Belongs to the gesture of the placement just before: one undo takes both back.
    bool continues = false;
    int model = 0;  ///< of the scene, by number
};
/// Takes back the last change that is not undone: a cut or a grab (with all that the body did
/// since), a restart, a placement, a parameter, pins or a box. A blade that is in the body is
/// lifted first; time goes on.
struct Undo {};
/// Brings back what the last undo took.
struct Redo {};
/// Lets time run, as at the start, or stand. While it stands, steps move nothing but the blade: it
/// cuts the body where that lies, no time passes, and a step costs no more than its cut.
struct SetTime {
    bool runs = true;
};

using Command = std::variant<MoveBlade, LiftBlade, SetParam, Grab, Drag, Release, Pin, MovePins,
                             AddBox, ChangeBox, RemoveBox, Restart, Place, Undo, Redo, SetTime>;

}  // namespace kerf
