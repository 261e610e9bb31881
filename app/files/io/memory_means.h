#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "app/files/io/errors.h"
#include "sim/run/start/memory_need.h"

namespace kerf::app {

/// What a body may take here.
struct MemoryMeans {
    static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

    std::uint64_t free = kNoLimit;           ///< that this process may still take [bytes]
    bool programRuns = false;                ///< with its kernels, so that this is taken already
    bool holdsGraphics = false;              ///< what the driver takes comes out of it, too
    std::uint64_t largestBuffer = kNoLimit;  ///< that the driver allows shaders to write [bytes]
};

/// The memory that this process may still take: of what the machine has available, what its
/// control groups and its own limits (RLIMIT_AS, RLIMIT_DATA) leave it, and KERF_MEMORY_BYTES,
/// whichever is least [bytes].
std::uint64_t freeMemory();
/// The means without a graphics context.
MemoryMeans memoryMeans();
/// The means with those of the context that is current on this thread.
MemoryMeans memoryMeansOfContext();

/// Throws MemoryShortage where `means` don't do for `need`. `what`: what the sentence begins with,
/// "bunny.ply".
void requireMemory(const std::string& what, const MemoryNeed& need, const MemoryMeans& means);
/// Throws MemoryShortage where less than `bytes` is free. `what`: the start of the sentence, such
/// as "a.ply: edges of 0.01 make 2 million triangles"; `help`: what to do.
void requireFree(const std::string& what, double bytes, const std::string& help);
/// The memory that a model needs, for people: "about 1.2 GB, and 0.6 GB of graphics memory;
/// 22.6 GB are free here".
std::string describeMemory(const MemoryNeed& need, std::uint64_t free);
/// The sentence for memory that ran out in the midst of something, "Cutting".
std::string outOfMemory(const std::string& doing);

}  // namespace kerf::app
