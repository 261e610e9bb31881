#pragma once

#include "shaders/shared/shared_types.h"
#include "sim/base/containers.h"
#include "sim/base/math.h"

namespace kerf {

inline std::uint32_t size32(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

inline shared::vec4 packed(const Vec3f& a, float w) {
    return {a.x(), a.y(), a.z(), w};
}
/// The values as the GPU stores them, with w = 0.
inline std::vector<shared::vec4> packed(const std::vector<Vec3f>& values) {
    return mapped(values, [](const Vec3f& a) { return packed(a, 0.0f); });
}
/// The values without w.
inline std::vector<Vec3f> unpacked(std::span<const shared::vec4> values) {
    return mapped(values, [](const shared::vec4& a) { return Vec3f(a.x, a.y, a.z); });
}

/// [m] or [m/s], as the values.
inline Bounds boundsOf(const std::vector<Vec3f>& values) {
    return boxOf(values, [](const Vec3f& u) -> Vec3 { return u.cast<double>(); });
}

}  // namespace kerf
