#pragma once

#include "app/files/export/export.h"
#include "app/files/io/file_io.h"
#include "sim/mesh/surface_mesh.h"
#include "tests/support/shapes.h"

namespace kerf::bench {

/// A sphere in a file of the temporary folder that is gone at the end.
class ModelFile {
  public:
    /// `name`: of the file, without its ending.
    ModelFile(const std::string& name, int triangles)
        : path(std::filesystem::temp_directory_path() / (name + ".ply")) {
        const int quads = static_cast<int>(std::ceil(std::sqrt(triangles / 12.0)));
        const SurfaceMesh mesh = test::cubeSphere(quads);
        app::writeOutputFile(path, app::encodeMesh(mesh, findPieces(mesh), app::MeshFormat::ply));
    }
    ~ModelFile() { std::filesystem::remove(path); }
    ModelFile(const ModelFile&) = delete;
    ModelFile& operator=(const ModelFile&) = delete;

    const std::filesystem::path path;
};

}  // namespace kerf::bench
