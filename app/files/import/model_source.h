#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/import/mending.h"
#include "app/files/import/model_faults.h"
#include "app/files/import/own_looks.h"
#include "app/files/io/errors.h"
#include "app/files/io/memory_means.h"
#include "app/files/jobs/work_progress.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_inspection.h"
#include "sim/run/start/placed_model.h"

namespace kerf::app {

/// What would leave nothing that is wrong with a model.
struct ModelHelp {
    int holes = 0;                     ///< so many, once filled; 0 where filling is no help
    std::vector<std::string> repairs;  ///< what a repair would do, one phrase each; empty: no help
    double thickness = 0;  ///< of its sheets, in the file's unit, with a repair; 0: no help
    bool isSheet = false;  ///< see repair::isSheet(); else filling or a repair suits it better
};

/// A model whose triangles could be read but not be cut.
class ModelFault : public InputError {
  public:
    explicit ModelFault(const std::string& sentence, ModelHelp help = {})
        : InputError(sentence), help_(std::move(help)) {}
    const ModelHelp& help() const { return help_; }
    /// The model and what is wrong with it where; null unless ReadOptions::findFaults.
    const std::shared_ptr<const FoundFaults>& found() const { return found_; }
    void setFound(std::shared_ptr<const FoundFaults> found) { found_ = std::move(found); }

  private:
    ModelHelp help_;
    std::shared_ptr<const FoundFaults> found_;
};

/// A model as it is cut, and what it keeps of its looks.
struct ModelMesh {
    // NOLINTNEXTLINE(google-explicit-constructor): a mesh is a model without looks of its own
    ModelMesh(SurfaceMesh surface, OwnLooks own = {})
        : mesh(std::move(surface)), looks(std::move(own)) {}

    SurfaceMesh mesh;
    OwnLooks looks;
    std::vector<std::string> remarks;        ///< sentences about what was left out of them
    std::vector<PlacedModel> placed = {{}};  ///< what the mesh consists of
    FileFacts facts{};
    Vec3 origin = Vec3::Zero();  ///< the point of the scene from which places are counted [m]
    /// What is poor about its triangles though it can be cut, by slot; empty unless
    /// ReadOptions::findFaults.
    repair::Faults faults;
};

struct ImportLimits;
struct ImportedModel;
struct ReadOptions;

/// Tells whether the file's name ends like that of a model that importModel() reads.
bool isModelFile(const std::filesystem::path& file);

/// Reads the triangles of a model file (OBJ, PLY, STL, glTF, GLB, OFF, and through assimp 3DS, DAE,
/// FBX) in a child process with limits, and welds each of its objects: see weldObjects(). Throws
/// InputError, and WorkCancelled where `progress` was cancelled, as all functions that take one.
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
/// importModel, then refuses with the sentence of the report what cannot be cut.
/// An inside-out model is turned; that is named in report->repairs. The report is filled for a
/// refused model as well.
SurfaceMesh loadModel(const std::filesystem::path& file, MeshReport* report = nullptr);

/// Options for reading a model.
struct ReadOptions : Mending {
    int object = 0;           ///< the number of the only object that is read, from 1; 0: all
    bool findFaults = false;  ///< to tell what is wrong where: ModelMesh::faults, ModelFault::found
    bool tryFilling = false;  ///< to tell in a ModelFault whether filling holes would help
    /// To tell in a ModelFault what a repair would do where filling is not tried or no help, and
    /// which thickness helps, up to findCrossingsUpTo. It is done for that, as mendModel() does it.
    bool tryRepair = false;
    /// In models of so many triangles at most, those that pass through others are counted.
    std::size_t findCrossingsUpTo = 0;
    /// The model is read to be cut with these means: of one that is beyond them nothing is taken.
    std::optional<MemoryMeans> means = std::nullopt;
    MeshReport* report = nullptr;  ///< filled for a refused model as well
    FileFacts* facts = nullptr;    ///< as well
    WorkProgress* progress = nullptr;
};
/// loadModel() with the looks that the model has, pictures decoded. A picture that can't be shown
/// is left out, with a remark. Throws ModelFault where a model can't be cut, MemoryShortage.
ModelMesh readModel(const std::filesystem::path& file, const ReadOptions& options);

/// What readModel() makes of what importWithLooks() has read of `file`.
ModelMesh surfaceOf(const std::filesystem::path& file, ImportedModel model,
                    const ReadOptions& options);

/// A model file as a mending leaves it.
struct MendedModel {
    ModelMesh model;
    MeshReport report;  ///< of the model as it is now, with what was done
};
/// Reads a model, repairs it, thickens it where asked (0: as proposed), remeshes it
/// where asked (no edge: proposedEdge()) and rounds it to floats, as files hold it. Throws
/// ModelFault where it can't be cut even then.
MendedModel mendModel(const std::filesystem::path& file, const Mending& mending);

}  // namespace kerf::app
