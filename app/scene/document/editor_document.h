#pragma once

#include "app/files/import/model_source.h"
#include "app/files/import/model_units.h"
#include "app/files/io/file_io.h"
#include "app/scene/document/stored_ends.h"
#include "app/session/session.h"
#include "render/scene/camera.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// A model file as it was read.
struct ReadModel {
    std::optional<FileStamp> stamp;
    std::string sha256;  ///< empty where the file was gone at once
};

/// A model or session that is open in the editor: the start state, ready to be simulated.
struct Document {
    std::string name;       ///< of the file, without folder and extension
    Session session;        ///< without events for a model file
    SurfaceMesh mesh;       ///< at rest, placed in the world [m]
    Bounds restBounds;      ///< of `mesh`
    render::Camera camera;  ///< the first view
    OwnLooks looks;         ///< of `mesh`
    std::string note;       ///< what was done on opening, one sentence; may be empty
    std::optional<UnitGuess> guess = std::nullopt;  ///< of a model file
    std::vector<PlacedModel> placed = {{}};         ///< what `mesh` consists of
    repair::Faults faults = {};                     ///< see ModelMesh
    std::vector<std::string> objects = {};          ///< of the file of a scene of one model
    bool inFile = true;                             ///< false: no file holds this scene
    bool makesTask = false;             ///< its task is being made: saved without the tries of it
    std::optional<StoredEnd> end = {};  ///< of a session, if it is known
    std::filesystem::path file = {};    ///< of the session; empty for none
    std::map<std::filesystem::path, ReadModel> read = {};  ///< its model files
};
/// The model files that have changed since.
std::vector<std::filesystem::path> changedModels(const Document& document);

/// The name of a document in this file: without folder, extension or kSessionEnding.
std::string shortName(const std::filesystem::path& file);

/// The memory for opening and cutting it in the editor.
MemoryNeed memoryNeedOf(const Document& document);

/// Opens a model or a session (*.kerf.json). Throws InputError, ModelFault among them, and
/// WorkCancelled if the progress of `options` was cancelled.
Document openDocument(const std::filesystem::path& file, const ReadOptions& options = {});

/// Opens the models of several files in one scene, each at the right of those before. Throws like
/// openDocument().
Document openModels(const std::vector<std::filesystem::path>& files, const ReadOptions& options);

/// Opens a scene that no file holds. Throws like openDocument().
Document openScene(const std::string& name, Session scene, const ReadOptions& options = {});
/// Opens a scene with the model of a file added as its last, at the right of the others and of
/// `right` [m]. Throws like openDocument(), and
/// InputError for a session.
Document openWithModel(const std::string& name, Session scene, const std::filesystem::path& file,
                       double right, const ReadOptions& options = {});

/// A scene of one model, whose file has `objects` objects, with a model for each.
Session parted(Session scene, int objects);

/// The memory that undo may take in the editor [bytes].
inline constexpr std::uint64_t kUndoBudget = 512'000'000;
/// The memory that checkpoints may take there, see Checkpoints [bytes].
inline constexpr std::uint64_t kCheckpointBudget = 256'000'000;

}  // namespace kerf::app
