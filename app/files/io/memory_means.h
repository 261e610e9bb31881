#pragma once

#include "app/files/io/errors.h"
#include "sim/run/start/memory_need.h"

namespace kerf::app {

/// The memory available for a body.
struct MemoryMeans {
    static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

    std::uint64_t free = kNoLimit;           ///< for this process [bytes]
    bool programRuns = false;                ///< with its kernels, whose memory is already taken
    bool holdsGraphics = false;              ///< includes the driver's memory
    std::uint64_t largestBuffer = kNoLimit;  ///< that the driver allows shaders to write [bytes]
};

/// The free memory for this process: the least of what the machine has available, the limits of its
/// control groups and its own (RLIMIT_AS, RLIMIT_DATA), and KERF_MEMORY_BYTES [bytes].
std::uint64_t freeMemory();
/// The means without a graphics context.
MemoryMeans memoryMeans();
/// The means with the current graphics context.
MemoryMeans memoryMeansOfContext();

/// Throws MemoryShortage if `means` don't suffice for `need`. `what`: start of the sentence,
/// "bunny.ply".
void requireMemory(const std::string& what, const MemoryNeed& need, const MemoryMeans& means);
/// Throws MemoryShortage if less than `bytes` is free. `what`: the start of the sentence, such as
/// "a.ply: edges of 0.01 make 2 million triangles"; `help`: what to do.
void requireFree(const std::string& what, double bytes, const std::string& help);
/// The memory that a model needs, for people: "about 1.2 GB, and 0.6 GB of graphics memory;
/// 22.6 GB are free here".
std::string describeMemory(const MemoryNeed& need, std::uint64_t free);
/// The message for running out of memory during `doing`, such as "Cutting".
std::string outOfMemory(const std::string& doing);

}  // namespace kerf::app
