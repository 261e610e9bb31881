#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kerf::gpu {

/// A limit of a driver, and the least value for Kerf's shaders.
struct DriverLimit {
    const char* name;    ///< as OpenGL has it
    const char* phrase;  ///< for messages: "storage buffers in a compute shader"
    std::int64_t has = 0;
    std::int64_t needs = 0;
};

/// The limits of the driver of the current context that Kerf's shaders may reach.
std::vector<DriverLimit> driverLimits();

/// What a driver lacks and what to do, in one sentence; empty if nothing.
std::string sentenceOfLack(std::span<const DriverLimit> limits);

}  // namespace kerf::gpu
