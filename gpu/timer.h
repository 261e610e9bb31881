#pragma once

#include <chrono>

namespace kerf::gpu {

/// Sums the GPU time between begin() and end() pairs since the last take(), by timestamp pairs
/// (GL_TIME_ELAPSED around compute reads 0 on llvmpipe).
class Timer {
  public:
    Timer() = default;
    ~Timer();
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

    /// Marks a place in the command stream; pairs of begin() and end() may not nest.
    void begin();
    void end();
    /// Milliseconds of all pairs since the last call; waits for the last one to be done.
    double takeMilliseconds();

  private:
    std::uint32_t nextQuery();

    std::vector<std::uint32_t> queries_;
    std::size_t used_ = 0;
};

/// The same for compute shaders. llvmpipe has run them when a dispatch returns, but takes
/// timestamps only with what is drawn next: there the processor's clock counts.
class ComputeTimer {
  public:
    /// Needs a current context.
    ComputeTimer();

    void begin();
    void end();
    double takeMilliseconds();

  private:
    using Clock = std::chrono::steady_clock;

    bool byClock_;
    Clock::time_point start_;
    double milliseconds_ = 0;
    Timer timer_;
};

}  // namespace kerf::gpu
