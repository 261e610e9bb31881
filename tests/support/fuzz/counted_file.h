#pragma once

#include "sim/base/math.h"

namespace kerf::test {

/// What a model file says that it has, told without the readers of Kerf.
struct FileCount {
    std::size_t triangles = 0;
    std::size_t least = 0;  ///< without parts of no area, in faces that come to a place twice
    std::optional<Bounds> bounds{};  ///< of the corners of its faces, where that is simple to tell
    std::string damage{};            ///< why it can't be a whole model; "" for none
};

/// Counts in the bytes of a file with that extension. Nothing for what it does not understand,
/// which is less than Kerf reads.
std::optional<FileCount> countOf(std::string_view ending, std::string_view bytes);

}  // namespace kerf::test
