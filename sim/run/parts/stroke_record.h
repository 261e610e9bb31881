#pragma once

#include "sim/cut/cut_types.h"

namespace kerf {

/// What the steps of a stroke did to the body.
struct StrokeRecord {
    int number = 0;         ///< as in SurfaceMesh::wallLabel, where it has cut
    int firstTriangle = 0;  ///< slot of the mesh from which on it made triangles
    int cutSteps = 0;       ///< steps that cut
    int refusedSteps = 0;   ///< steps that were refused, in one group of pieces at least
    int retriedSteps = 0;   ///< steps that took more than one try
    int cutAnew = 0;        ///< times that a front was let go and cut anew from behind it
    SweptArea swept;        ///< by the blade, inside of the material
    Debris debris;          ///< removed when it ended

    /// Adds a step.
    void add(const CutResult& step);
    /// Adds the steps of another stroke.
    void add(const StrokeRecord& other);
    /// Whether it met the body: one that did not leaves no trace.
    bool metBody() const { return cutSteps + refusedSteps > 0; }
};

}  // namespace kerf
