#pragma once

#include <filesystem>

#include "app/files/import/import_protocol.h"

namespace kerf::app {

/// Reads a glTF 2.0 or GLB file as its scene shows it at rest: nodes where they stand, skins by
/// their joints, morph targets by their weights, numbers quantized or sparse, colours, materials
/// and the first texture of each. Points and lines are left out. Throws InputError for what is
/// broken, and by its name for an extension that changes the shape and is not read.
ImportedModel readGltf(const std::filesystem::path& file);

}  // namespace kerf::app
