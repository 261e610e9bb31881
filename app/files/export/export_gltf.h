#pragma once

#include "app/files/export/export_mesh.h"

namespace kerf::app {

/// glTF 2.0 with a node and a mesh per piece and a primitive per material, and the images, as one
/// binary file. Normals are sharp where a cut meets the skin.
std::string encodeGlb(const ExportMesh& mesh);
/// Encodes a mesh as glTF in JSON with buffer and images in it.
std::string encodeGltf(const ExportMesh& mesh);
/// Encodes a mesh as glTF in JSON beside its buffer and images. `images` are the names of their
/// files; `nameOf` returns the name of the buffer's file for its bytes.
std::string encodeGltfBeside(const ExportMesh& mesh, const std::vector<std::string>& images,
                             const std::function<std::string(std::string)>& nameOf);

}  // namespace kerf::app
