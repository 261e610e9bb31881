#pragma once

#include <filesystem>

#include "app/files/import/import_protocol.h"

namespace kerf::app {

/// Reads an STL file: binary, with its facets' colours where it has some, also where bytes stand
/// behind the last facet; or text in letters of either kind, with comments and blank lines. Normals
/// are those of the facets, whatever the file says. Throws InputError where it ends too early, and
/// for a corner that is no number.
ImportedModel readStl(const std::filesystem::path& file);

}  // namespace kerf::app
