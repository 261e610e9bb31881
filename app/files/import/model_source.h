#pragma once

#include "app/files/import/import_answer.h"
#include "app/files/import/import_process.h"
#include "app/files/import/model_faults.h"
#include "app/files/import/own_looks.h"
#include "app/files/io/errors.h"
#include "app/files/io/memory_means.h"
#include "app/files/jobs/background_job.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_inspection.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

/// A model that could be read but can't be cut.
class ModelFault : public InputError {
  public:
    explicit ModelFault(const std::string& sentence, ModelHelp help = {})
        : InputError(sentence), help_(std::move(help)) {}
    const ModelHelp& help() const { return help_; }
    /// The model, and its faults with ImportOrder::findFaults.
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
    /// ImportOrder::findFaults.
    repair::Faults faults;
};

/// Whether importModel() reads files with this extension.
bool isModelFile(const std::filesystem::path& file);

/// The program that reads models: $KERF_IMPORT if set, else kerf-import beside this one.
std::filesystem::path importProgram();

/// Reads a model file (OBJ, PLY, STL, glTF, GLB, OFF, VTK, VTP, VTU, Gmsh, and through assimp
/// 3DS, DAE, FBX) once and does each of what is ordered, in a child process with limits; see
/// answersTo(). Throws InputError if it can't be read, MemoryShortage if it can't be cut here, and
/// WorkCancelled if `progress` was cancelled, like all functions that take one.
std::vector<ImportAnswer> importModels(const std::filesystem::path& file,
                                       const std::vector<ImportOrder>& orders,
                                       WorkProgress* progress = nullptr,
                                       const ImportLimits& limits = {});
/// The same of one order.
ImportAnswer importModel(const std::filesystem::path& file, const ImportOrder& order = {},
                         WorkProgress* progress = nullptr, const ImportLimits& limits = {});

/// Options for reading a model.
struct ReadOptions : ImportOrder {
    MeshReport* report = nullptr;  ///< set for a model that can't be cut, too
    WorkProgress* progress = nullptr;
};
/// Reads a model to cut, with its looks. One that is inside out is reversed, which is listed in
/// report->repairs. An image that can't be shown is skipped, with a remark. Throws ModelFault with
/// the sentence of the report if it can't be cut, and what importModel() throws.
ModelMesh readModel(const std::filesystem::path& file, const ReadOptions& options);
/// The same of an answer for `file`.
ModelMesh cuttableModel(const std::filesystem::path& file, ImportAnswer answer);
/// The surface of a model without its looks.
SurfaceMesh loadModel(const std::filesystem::path& file, MeshReport* report = nullptr);

}  // namespace kerf::app
