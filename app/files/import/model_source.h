#pragma once

#include "app/files/import/import_appearance.h"
#include "app/files/import/model_faults.h"
#include "app/files/io/errors.h"
#include "app/files/io/memory_means.h"
#include "app/files/jobs/background_job.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_inspection.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

/// The repairs that would fix a model.
struct ModelHelp {
    int holes = 0;                     ///< number to fill; 0 if that does not help
    std::vector<std::string> repairs;  ///< what a repair would do; empty if it does not help
    double thickness = 0;              ///< of its sheets, in the file's unit; 0 if it does not help
    bool isSheet = false;  ///< see repair::isSheet(); else filling or a repair is better
};

/// A model that could be read but can't be cut.
class ModelFault : public InputError {
  public:
    explicit ModelFault(const std::string& sentence, ModelHelp help = {})
        : InputError(sentence), help_(std::move(help)) {}
    const ModelHelp& help() const { return help_; }
    /// The model and its faults; null unless ReadOptions::findFaults.
    const std::shared_ptr<const FoundFaults>& found() const { return found_; }
    void setFound(std::shared_ptr<const FoundFaults> found) { found_ = std::move(found); }

  private:
    ModelHelp help_;
    std::shared_ptr<const FoundFaults> found_;
};

/// A model to cut, with its looks.
struct ModelMesh {
    // NOLINTNEXTLINE(google-explicit-constructor): a mesh is a model without looks of its own
    ModelMesh(SurfaceMesh surface, OwnLooks own = {})
        : mesh(std::move(surface)), looks(std::move(own)) {}

    SurfaceMesh mesh;
    OwnLooks looks;
    std::vector<std::string> remarks;        ///< sentences about skipped looks
    std::vector<PlacedModel> placed = {{}};  ///< the models of the mesh
    FileFacts facts{};
    Vec3 origin = Vec3::Zero();  ///< the origin of positions in the scene [m]
    /// Faults of its triangles, by slot, though it can be cut; empty unless
    /// ReadOptions::findFaults.
    repair::Faults faults;
};

struct ImportLimits;
struct ImportedModel;
struct ReadOptions;

/// Whether importModel() reads files with this extension.
bool isModelFile(const std::filesystem::path& file);

/// Reads the triangles of a model file (OBJ, PLY, STL, glTF, GLB, OFF, VTK, VTP, VTU, Gmsh, and
/// through assimp 3DS, DAE, FBX) in a child process with limits, and welds each of its objects: see
/// weldObjects(). Throws InputError, and WorkCancelled if `progress` was cancelled, like all
/// functions that take one.
TriangleSoup importModel(const std::filesystem::path& file, WorkProgress* progress = nullptr);
TriangleSoup importModel(const std::filesystem::path& file, const ImportLimits& limits,
                         WorkProgress* progress = nullptr);
/// Reads a model with its materials and the bytes of their images.
ImportedModel importWithLooks(const std::filesystem::path& file, const ImportLimits& limits,
                              WorkProgress* progress = nullptr);
ImportedModel importWithLooks(const std::filesystem::path& file, const ReadOptions& options);
/// The model in an answer of the child process, welded. Throws InputError with what is wrong,
/// without the file's name.
ImportedModel modelOfAnswer(std::string_view answer);
/// importModel(), then refuses a model that can't be cut, with the sentence of the report. An
/// inside-out model is reversed, which is listed in report->repairs. The report is set for a
/// refused model, too.
SurfaceMesh loadModel(const std::filesystem::path& file, MeshReport* report = nullptr);

/// Options for reading a model.
struct ReadOptions : Mending {
    int object = 0;           ///< the number of the only object to read, from 1; 0: all
    bool findFaults = false;  ///< sets ModelMesh::faults, ModelFault::found
    bool tryFilling = false;  ///< a ModelFault says whether filling holes would help
    /// A ModelFault says what a repair would do if filling is not tried or does not help, and which
    /// thickness helps, up to findCrossingsUpTo. It is tried for that, as in mendModel().
    bool tryRepair = false;
    /// Intersecting triangles are counted in models of at most this many triangles.
    std::size_t findCrossingsUpTo = 0;
    /// The memory for cutting the model: one that exceeds it is not read.
    std::optional<MemoryMeans> means = std::nullopt;
    MeshReport* report = nullptr;  ///< set for a refused model, too
    FileFacts* facts = nullptr;    ///< the same
    WorkProgress* progress = nullptr;
};
/// loadModel() with the model's looks, images decoded. An image that can't be shown is skipped,
/// with a remark. Throws ModelFault if a model can't be cut, MemoryShortage.
ModelMesh readModel(const std::filesystem::path& file, const ReadOptions& options);

/// readModel() from the result of importWithLooks() for `file`.
ModelMesh surfaceOf(const std::filesystem::path& file, ImportedModel model,
                    const ReadOptions& options);

/// A repaired model file.
struct MendedModel {
    ModelMesh model;
    MeshReport report;  ///< of the repaired model, with the repairs
};
/// Reads a model, repairs it, optionally thickens it (0: as proposed) and remeshes it (no edge:
/// proposedEdge()), and rounds it to floats, as in files. Throws ModelFault if it can't be cut even
/// then.
MendedModel mendModel(const std::filesystem::path& file, const Mending& mending);

}  // namespace kerf::app
