#pragma once

#include <functional>
#include <memory>

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
    SurfaceMesh mesh;  ///< at rest
    BodyUpdater body;
    Cutter cutter;
    bool closed = false;  ///< see checkClosedManifold
};

/// A body at rest with all that takes long and needs no GPU. Made on any thread; a BodyUpload takes
/// it over. It owns the mesh at an address that stays, to which body and cutter refer.
struct PreparedBody {
    /// Prepares a mesh at rest, in world units.
    explicit PreparedBody(SurfaceMesh atRest, const StageListener& enter = {});

    std::unique_ptr<SurfaceMesh> mesh;
    std::unique_ptr<BodyUpdater> body;
    std::unique_ptr<Cutter> cutter;
    VertexPages pages;
    std::shared_ptr<const UncutBody> uncut;
};

}  // namespace kerf
