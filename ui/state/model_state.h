#pragma once

#include <string>
#include <vector>

#include "sim/base/math.h"
#include "sim/base/placement.h"

namespace kerf::ui {

/// An open model and its placement.
struct ModelState {
    std::string name;
    Placement placement;
    Vec3 size = Vec3::Zero();  ///< of the uncut model, along the axes of the scene [m]
    std::string guess;         ///< the guess of its unit and axis, and why; may be empty
    std::string physics;       ///< the physics of that size
    std::string triangles;     ///< their number and quality
    double edge = 0;           ///< proposed edge length, in the unit of its file
    double remeshed = 0;       ///< about how many triangles it has then
    bool crosses = false;      ///< its pieces may intersect, and can be united
    int material = -1;         ///< of ModelPanelState::materials; -1 where it is none of them
};

/// A material that a body can be given.
struct MaterialRow {
    std::string label;
    std::string tooltip;  ///< its values, their spread and sources
    bool own = false;     ///< of a user file, not built in
};

/// What the panel of models shows.
struct ModelPanelState {
    std::vector<ModelState> models;      ///< of the scene, by number
    int objects = 0;                     ///< of the only model's file; to part if two or more
    std::vector<MaterialRow> materials;  ///< to choose from
    bool untouched = true;               ///< no cut was made that a placement would undo
    bool live = true;                    ///< small enough to follow a drag
    int faultCount = 0;                  ///< of the open model, marked or not
};

}  // namespace kerf::ui
