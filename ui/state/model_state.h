#pragma once

#include <string>
#include <vector>

#include "sim/base/math.h"
#include "sim/base/placement.h"

namespace kerf::ui {

/// The model that is open, and how its numbers became the metres of the scene.
struct ModelState {
    std::string name;
    Placement placement;
    Vec3 size = Vec3::Zero();  ///< of the uncut model, along the axes of the scene [m]
    std::string guess;         ///< what was taken for its unit and axis, and why; may be empty
    std::string physics;       ///< what physics makes of that size
    std::string triangles;     ///< how many there are, and how poor they are
    double edge = 0;           ///< the length to propose for edges, in the unit of its file
    double remeshed = 0;       ///< about so many triangles it has with these
    bool crosses = false;      ///< pieces of it may pass through each other, and can be united
    int material = -1;         ///< of ModelPanelState::materials; -1 where it is none of them
};

/// A material that a body can be given.
struct MaterialRow {
    std::string label;
    std::string tooltip;  ///< its values, their spread and sources
    bool own = false;     ///< of a file of the person's, rather than one that comes with Kerf
};

/// What the panel of models shows.
struct ModelPanelState {
    std::vector<ModelState> models;      ///< of the scene, by number
    int objects = 0;                     ///< of the only model's file; fewer than two: none to part
    std::vector<MaterialRow> materials;  ///< that a model can be given
    bool untouched = true;               ///< no cut was made that a placement would undo
    bool live = true;                    ///< small enough to follow a drag
    int faultCount = 0;                  ///< of the open model, marked or not
};

}  // namespace kerf::ui
