#pragma once

#include "sim/base/placement.h"

namespace kerf {

/// A model of a scene within the common mesh.
struct PlacedModel {
    Placement placement = {};  ///< from its file to metres of the scene
    int firstVertex = 0;       ///< of the uncut mesh; those of the next model follow its own
    bool operator==(const PlacedModel&) const = default;
};

}  // namespace kerf
