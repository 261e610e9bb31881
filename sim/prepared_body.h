#pragma once

#include <functional>
#include <memory>

#include "sim/body/body_updater.h"
#include "sim/cut/cutter.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/solve/vertex_pages.h"

namespace kerf {

/// Told the name of each part of a long piece of work before it begins; may throw to end the work.
using StageListener = std::function<void(const char* stage)>;

/// A body at rest with all that takes long and needs no GPU. Made on any thread; a BodyUpload takes
/// it over. It owns the mesh at an address that stays, to which body and cutter refer.
struct PreparedBody {
    /// `uncut` at rest, in world units.
    explicit PreparedBody(SurfaceMesh uncut, const StageListener& enter = {});

    std::unique_ptr<SurfaceMesh> mesh;
    std::unique_ptr<BodyUpdater> body;
    std::unique_ptr<Cutter> cutter;
    VertexPages pages;
    bool closed = false;  ///< see checkClosedManifold
};

}  // namespace kerf
