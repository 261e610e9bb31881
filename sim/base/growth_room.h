#pragma once

#include <cstddef>

namespace kerf {

/// How much capacity to reserve where cuts will add elements: growing later would move all of them
/// in the middle of a stroke. Unused capacity takes no memory in large bodies.
inline std::size_t withGrowthRoom(std::size_t count) {
    return 2 * count;
}

}  // namespace kerf
