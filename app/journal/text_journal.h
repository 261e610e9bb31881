#pragma once

#include "app/journal/journal.h"

namespace kerf::app {

/// A journal that an older Kerf left behind as lines of JSON: as a database in its place. Null
/// where it belongs to a window, or nothing can be recovered.
std::shared_ptr<Journal> journalOfText(const std::filesystem::path& file);

/// What such lines say, up to the last that is complete and valid; none without a first line.
std::optional<KeptWork> workInText(std::string_view text);

}  // namespace kerf::app
