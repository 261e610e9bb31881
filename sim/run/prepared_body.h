#pragma once

#include <functional>
#include <memory>

#include "sim/base/placement.h"
#include "sim/body/body_updater.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/solve/vertex_pages.h"

namespace kerf {

/// Told the name of each part of a long piece of work before it begins; may throw to end the work.
using StageListener = std::function<void(const char* stage)>;

/// A body before anything was done to it, to come back to. Body and cutter refer to the
/// mesh of the simulation that they are copied into.
struct UncutBody {
    SurfaceMesh mesh;  ///< at rest, where the placement puts it [m]
    BodyUpdater body;
    Cutter cutter;
    bool closed = false;  ///< see checkClosedManifold
    Placement placement;  ///< how the numbers of its file became the metres of the mesh
};

/// Makes all that a body needs of `atRest`, which lies where `placement` has put it.
UncutBody makeUncutBody(SurfaceMesh& atRest, const Placement& placement,
                        const StageListener& enter = {});

/// A body at rest with all that takes long and needs no GPU. Made on any thread; a BodyUpload takes
/// it over. It owns the mesh at an address that stays, to which body and cutter refer.
struct PreparedBody {
    /// Prepares a mesh at rest, in world units, which lies where `placement` has put it.
    explicit PreparedBody(SurfaceMesh atRest, const StageListener& enter = {},
                          const Placement& placement = {});

    std::unique_ptr<SurfaceMesh> mesh;
    std::unique_ptr<BodyUpdater> body;
    std::unique_ptr<Cutter> cutter;
    VertexPages pages;
    std::shared_ptr<const UncutBody> uncut;
};

}  // namespace kerf
