#pragma once

#include <cstddef>

namespace kerf {

/// How many things to make room for at first where cuts will add some: growing later would move all
/// of them in the middle of a stroke. Room that is not used takes no memory in large bodies.
inline std::size_t withGrowthRoom(std::size_t count) {
    return 2 * count;
}

}  // namespace kerf
