#pragma once

#include "sim/cut/cut_types.h"

namespace kerf {

/// The results of the steps of a stroke.
struct StrokeRecord {
    int number = 0;         ///< as in SurfaceMesh::wallLabel, if it has cut
    int firstTriangle = 0;  ///< first slot of its triangles
    int cutSteps = 0;       ///< steps that cut
    int refusedSteps = 0;   ///< steps that were refused, in one group of pieces at least
    int retriedSteps = 0;   ///< steps that took more than one try
    int cutAnew = 0;        ///< restarts behind a dropped front
    SweptArea swept{};      ///< by the blade, inside the material
    Debris debris{};        ///< removed when it ended

    /// Adds a step.
    void add(const CutResult& step);
    /// Adds the steps of another stroke.
    void add(const StrokeRecord& other);
    /// Whether it met the body; one that did not is not recorded.
    bool metBody() const { return cutSteps + refusedSteps > 0; }
};

}  // namespace kerf
