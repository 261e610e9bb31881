#pragma once

#include "app/files/import/import_answer.h"

namespace kerf::app {

/// Reads a model file by its extension, with its vertices as in the file. Throws InputError and
/// what assimp throws: see plainReason().
ImportedModel readModelFile(const std::filesystem::path& file);

/// Says in words of ours why a file was not read.
std::string plainReason(const std::exception& error);

}  // namespace kerf::app
