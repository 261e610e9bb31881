#pragma once

#include "sim/base/placement.h"
#include "sim/body/body_model.h"
#include "sim/body/body_updater.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/solve/gpu_solver.h"
#include "sim/solve/solver_pieces.h"

namespace kerf {

/// A model of a scene within the common mesh.
struct PlacedModel {
    Placement placement = {};  ///< from its file to metres of the scene
    int firstVertex = 0;       ///< of the uncut mesh; those of the next model follow its own
    bool operator==(const PlacedModel&) const = default;
};

/// Called with the name of each stage of long work before it begins; may throw to cancel.
using StageListener = std::function<void(const char* stage)>;

/// The original body, to restore.
struct UncutBody {
    SurfaceMesh mesh;  ///< at rest, as placed [m]
    /// The mesh that body, cutter and all copies of them refer to: the running mesh.
    std::shared_ptr<SurfaceMesh> running;
    BodyUpdater body;
    Cutter cutter;
    bool closed = false;              ///< see checkClosedManifold
    std::vector<PlacedModel> models;  ///< that it consists of; one at least

    /// The number of the model that a vertex belongs to.
    int modelOf(int vertex) const;
    /// The longest diagonal of its models' boxes at rest [m].
    double sizeOfModels() const;
};

/// Makes the uncut body of a mesh at rest that consists of `models`. On any thread.
std::shared_ptr<const UncutBody> makeUncutBody(SurfaceMesh atRest, std::vector<PlacedModel> models,
                                               const StageListener& enter = {});
/// The mesh of an uncut body with new placements of its models. On any thread.
SurfaceMesh placedMesh(const UncutBody& uncut, std::span<const PlacedModel> models);
/// The longest diagonal of these models' boxes, where `restPositions` are those of all [m].
double sizeOfModels(std::span<const Vec3> restPositions, std::span<const PlacedModel> models);

/// A body at rest with all expensive parts that need no GPU. Made on any thread; a BodyUpload takes
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

/// The upload of a prepared body to the GPU, in portions, so that frames can be drawn in between.
/// Then a Simulation takes it over.
class BodyUpload {
  public:
    /// Compiles the kernels for the OpenGL context that is current. Throws gpu::ShaderError.
    explicit BodyUpload(PreparedBody prepared);

    bool done() const { return next_ == GpuSolver::kModelPortions; }
    /// Uploads the next portion; not once it is done. Throws gpu::OutOfMemory.
    void advance();
    void finish();

  private:
    friend class Simulation;

    PreparedBody prepared_;
    BodyState state_;
    std::unique_ptr<GpuSolver> solver_;
    int next_ = 0;
};

}  // namespace kerf
