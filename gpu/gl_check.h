#pragma once

#include <cstddef>
#include <string_view>

namespace kerf::gpu {

/// Drops pending OpenGL errors, so that the next check reports one call only.
void forgetErrors();

/// Throws OutOfMemory naming `what` and `bytes` where the driver reports GL_OUT_OF_MEMORY.
void throwIfOutOfMemory(std::string_view what, std::size_t bytes);

/// The most bytes that a shader sees of a buffer bound as storage.
std::size_t storageLimit();
/// The most bytes of a buffer that shaders read as texels of one word, the smallest.
std::size_t texelLimit();

/// The capacity of a buffer that is to grow to `bytes`: half as much again as `capacity`, at least
/// `bytes`, at most `limit`. Throws OutOfMemory if `bytes` are beyond that.
std::size_t grownCapacity(std::size_t capacity, std::size_t bytes, std::size_t limit);

}  // namespace kerf::gpu
