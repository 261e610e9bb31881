#pragma once

#include <filesystem>
#include <string>

#include "app/session/session.h"
#include "render/scene/camera.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// A model or session that is open in the editor: the start state, ready to be simulated.
struct Document {
    std::string name;            ///< of the file, without folder and extension
    Session session;             ///< a model file makes one without events
    SurfaceMesh mesh;            ///< at rest, placed in the world [m]
    Bounds restBounds;           ///< of `mesh`
    render::Camera camera;       ///< the first view
    std::vector<CornerUvs> uvs;  ///< of `mesh`, by triangle slot, or none
    std::string note;            ///< what was done to it on the way in, one sentence; may be empty
};

/// Models come in any unit: one is scaled so that its bounds have this diagonal [m], and put a
/// little above the floor.
inline constexpr double kModelDiagonal = 1.5;

/// Opens a model or a session (*.kerf.json). Throws InputError, ModelFault among them, and
/// WorkCancelled where the progress of `options` was cancelled.
Document openDocument(const std::filesystem::path& file, const ReadOptions& options = {});

/// Opens what the editor shows without a file, assets/sessions/drop-in.kerf.json. Throws
/// InputError.
Document openDefaultDocument();

/// Scale and translation that bring `bounds` to `diagonal` [m], centred over the origin, the
/// lowest point a fiftieth of the diagonal above the floor at 0.
Placement fitPlacement(const Bounds& bounds, double diagonal);

}  // namespace kerf::app
