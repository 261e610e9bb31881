#pragma once

namespace kerf::app {

/// A DAE file as assimp can read it: in UTF-8, with single blanks in its lists, and without holes
/// in polygons, to which a bridge leads instead. Throws InputError for broken XML.
std::string plainDae(std::string_view bytes);

}  // namespace kerf::app
