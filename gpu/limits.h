#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kerf::gpu {

/// A limit of a driver, and what Kerf's shaders need of it at least.
struct DriverLimit {
    const char* name;    ///< as OpenGL has it
    const char* phrase;  ///< as people say it: "storage buffers in a compute shader"
    std::int64_t has = 0;
    std::int64_t needs = 0;
};

/// The limits of the driver of the current context, those that Kerf's shaders could meet.
std::vector<DriverLimit> driverLimits();

/// What a driver lacks, in one sentence that tells what to do; empty where it has all.
std::string sentenceOfLack(std::span<const DriverLimit> limits);

}  // namespace kerf::gpu
