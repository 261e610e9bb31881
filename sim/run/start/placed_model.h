#pragma once

#include "sim/base/placement.h"

namespace kerf {

/// A model of a scene, as it lies in the mesh of all of them.
struct PlacedModel {
    Placement placement = {};  ///< how the numbers of its file became metres of the scene
    int firstVertex = 0;       ///< of the uncut mesh; those of the next model follow its own
    bool operator==(const PlacedModel&) const = default;
};

}  // namespace kerf
