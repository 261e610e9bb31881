#pragma once

#include <cstddef>
#include <string_view>

namespace kerf::gpu {

/// Drops the OpenGL errors that are pending, so that the next check speaks of one call only.
void forgetErrors();

/// Throws OutOfMemory naming `what` and `bytes` where the driver reports GL_OUT_OF_MEMORY.
void throwIfOutOfMemory(std::string_view what, std::size_t bytes);

/// The capacity of storage that is to grow to `bytes`: half as much again as `capacity`, at least
/// `bytes`, at most the driver's limit. Throws OutOfMemory where `bytes` are beyond it.
std::size_t grownCapacity(std::size_t capacity, std::size_t bytes);

}  // namespace kerf::gpu
