#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shaders/shared/shared_types.h"
#include "sim/base/math.h"

namespace kerf {

inline std::uint32_t size32(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

inline shared::vec4 packed(const Vec3f& a, float w) {
    return {a.x(), a.y(), a.z(), w};
}
/// The values as the GPU stores them, with w = 0.
std::vector<shared::vec4> packed(const std::vector<Vec3f>& values);
/// The values without w.
std::vector<Vec3f> unpacked(std::span<const shared::vec4> values);

/// [m] or [m/s], as the values.
Bounds boundsOf(const std::vector<Vec3f>& values);

}  // namespace kerf
