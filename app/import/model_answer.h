#pragma once

#include "app/files/import/import_answer.h"

namespace kerf::app {

/// Reads a model file and does what is ordered: welds each of its objects (weldObjects()), mends,
/// looks for faults, decodes images. Whatever fails is in the answer.
ImportAnswer answerTo(const std::filesystem::path& file, const ImportOrder& order);

/// The same of a model that was read; `file` is named in sentences alone.
ImportAnswer answerFor(const std::filesystem::path& file, ImportedModel model,
                       const ImportOrder& order);

/// The main job of kerf-import: answers on standard output within the limits of its parent.
int runImport(const std::filesystem::path& file, std::string_view order);

}  // namespace kerf::app
