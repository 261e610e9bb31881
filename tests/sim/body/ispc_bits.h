#pragma once

#include <bit>

#include "shaders/shared/constraints.h"

namespace kerf::test {

/// Whether two ISPC records are the same, bit for bit.
inline bool sameBits(const shared::IspcConstraint& a, const shared::IspcConstraint& b) {
    using Words = std::array<std::uint32_t, sizeof(shared::IspcConstraint) / 4>;
    return std::bit_cast<Words>(a) == std::bit_cast<Words>(b);
}

}  // namespace kerf::test
