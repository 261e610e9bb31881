#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "sim/body/body_updater.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/start/placed_model.h"
#include "sim/solve/vertex_pages.h"

namespace kerf {

/// Told the name of each part of a long piece of work before it begins; may throw to end the work.
using StageListener = std::function<void(const char* stage)>;

/// A body before anything was done to it, to come back to.
struct UncutBody {
    SurfaceMesh mesh;  ///< at rest, where the placement puts it [m]
    /// The mesh that body and cutter refer to, and so do all copies of them: who runs one of these
    /// has the running mesh there.
    std::shared_ptr<SurfaceMesh> running;
    BodyUpdater body;
    Cutter cutter;
    bool closed = false;              ///< see checkClosedManifold
    std::vector<PlacedModel> models;  ///< that it consists of; one at least

    /// The number of the model that a vertex is of.
    int modelOf(int vertex) const;
    /// The longest diagonal of its models' boxes at rest [m].
    double sizeOfModels() const;
};

/// Makes all that a body needs of a mesh at rest, which consists of `models`. On any thread.
std::shared_ptr<const UncutBody> makeUncutBody(SurfaceMesh atRest, std::vector<PlacedModel> models,
                                               const StageListener& enter = {});
/// The mesh of an uncut body, with its models put elsewhere. On any thread.
SurfaceMesh placedMesh(const UncutBody& uncut, std::span<const PlacedModel> models);
/// The longest diagonal of these models' boxes, where `restPositions` are those of all [m].
double sizeOfModels(std::span<const Vec3> restPositions, std::span<const PlacedModel> models);

/// A body at rest with all that takes long and needs no GPU. Made on any thread; a BodyUpload takes
/// it over. Body and cutter refer to uncut->running.
struct PreparedBody {
    /// Prepares a mesh at rest, in world units, which consists of `models`.
    explicit PreparedBody(SurfaceMesh atRest, const StageListener& enter = {},
                          std::vector<PlacedModel> models = {{}});

    std::shared_ptr<const UncutBody> uncut;
    std::unique_ptr<BodyUpdater> body;
    std::unique_ptr<Cutter> cutter;
    VertexPages pages;
};

}  // namespace kerf
