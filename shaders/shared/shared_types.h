// Lets one header be valid C++20 and GLSL 4.50. Only vec4, uvec4, float, uint and int may be used
// between SHARED_BEGIN and SHARED_END: vec3 and bool are laid out differently on the two sides.
#pragma once

#ifdef __cplusplus
#include <cstdint>
#define SHARED_BEGIN namespace kerf::shared {
#define SHARED_END }
namespace kerf::shared {
using uint = std::uint32_t;
struct alignas(16) vec4 {
    float x, y, z, w;
};
struct alignas(16) uvec4 {
    uint x, y, z, w;
};
}  // namespace kerf::shared
#define SHARED_CONST inline constexpr
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_CONST const
#endif
