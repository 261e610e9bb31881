#pragma once

#include "app/files/import/import_answer.h"

namespace kerf::app {

/// Reads a model file once and does each of what is ordered: welds each of its objects
/// (weldObjects()), mends, looks for faults, decodes images. Whatever fails is in the answers. The
/// first order's memory is that of all.
std::vector<ImportAnswer> answersTo(const std::filesystem::path& file,
                                    const std::vector<ImportOrder>& orders);

/// The same of a model that was read, and one order; `file` is named in sentences alone.
ImportAnswer answerFor(const std::filesystem::path& file, ImportedModel model,
                       const ImportOrder& order);

/// The main job of kerf-import: answers on standard output within the limits of its parent.
int runImport(const std::filesystem::path& file, const std::vector<std::string>& orders);

}  // namespace kerf::app
