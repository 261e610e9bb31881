#pragma once

#include <string>

#include "app/files/export_mesh.h"

namespace kerf::app {

/// glTF 2.0 with a node and a mesh per piece and a primitive per material ("skin", "cut"), as one
/// binary file. Normals are sharp where a cut meets the skin.
std::string encodeGlb(const ExportMesh& mesh);
/// Encodes a mesh as glTF in JSON with the buffer in it.
std::string encodeGltf(const ExportMesh& mesh);

}  // namespace kerf::app
