#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/work_progress.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// An input (model, session, image) is missing or invalid: what() is one sentence with what, where
/// and what to do. Exit code 3.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Names of the builtin models: sphere20, sphere80, sphere768, banana, octopus.
const std::vector<std::string>& builtinModels();
/// The file of a builtin model below assets/models. Throws InputError for an unknown name.
std::filesystem::path builtinModelFile(const std::string& name);

/// Largest model file that is read [bytes].
inline constexpr std::uintmax_t kMaxModelBytes = 1'000'000'000;

struct ImportLimits;

/// Reads the triangles of a model file (OBJ, PLY, STL, glTF, GLB, OFF, 3DS, DAE, FBX) through
/// assimp, in a child process with limits, and welds them exactly. Throws InputError, and
/// WorkCancelled where `progress` was cancelled, as all functions that take one.
TriangleSoup importModel(const std::filesystem::path& file, WorkProgress* progress = nullptr);
TriangleSoup importModel(const std::filesystem::path& file, const ImportLimits& limits,
                         WorkProgress* progress = nullptr);
/// importModel, then refuses with the sentence of the report what cannot be cut.
/// An inside-out model is turned; that is named in report->repairs. The report is filled for a
/// refused model as well.
SurfaceMesh loadModel(const std::filesystem::path& file, MeshReport* report = nullptr,
                      WorkProgress* progress = nullptr);

/// The hidden verb of the child process: reads `file`, writes the triangles to standard output.
int runImportWorker(const std::filesystem::path& file);

}  // namespace kerf::app
