#pragma once

#include "app/files/export/export_mesh.h"

namespace kerf::app {

/// VTK XML PolyData (.vtp), as ParaView and VTK read it, with arrays in base64: of the cells
/// `piece` (Int32, from 0), `cut` (UInt8, 1 on faces that a cut made), `strain` (Float32) and
/// `piece_volume` (Float64), of the points `Normals` and `velocity` (Float32).
std::string encodeVtp(const ExportMesh& mesh);

}  // namespace kerf::app
