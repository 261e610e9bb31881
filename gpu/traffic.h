#pragma once

namespace kerf::gpu {

/// Counts of driver calls, to estimate the cost on a GPU.
struct Traffic {
    std::uint64_t dispatches = 0;  ///< of kernels, indirect ones too
    std::uint64_t indirect = 0;    ///< of these: those with the number of groups in a buffer
    std::uint64_t barriers = 0;    ///< calls of glMemoryBarrier
    std::uint64_t waits = 0;       ///< for a fence
    std::uint64_t reads = 0;       ///< of a buffer, each of which waits for all before it
    std::uint64_t bytesUp = 0;     ///< written into buffers
    std::uint64_t bytesDown = 0;   ///< of reads and waits
};
/// The difference of two counts.
Traffic operator-(const Traffic& now, const Traffic& before);

/// The counts of this process. One thread at a time may use OpenGL and this.
Traffic& traffic();

/// glMemoryBarrier with these bits, counted.
void barrier(std::uint32_t bits);
/// Makes what kernels wrote visible to the buffer calls that follow, unless it is already.
void updateBarrier();
/// Another OpenGL context has become current: what its kernels wrote may not be visible yet.
void noteOtherContext();

}  // namespace kerf::gpu
