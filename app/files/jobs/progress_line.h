#pragma once

#include <chrono>
#include <string>

namespace kerf::app {

/// A line on the terminal that is overwritten and removed at the end; nothing if standard error is
/// no terminal.
class ProgressLine {
  public:
    /// Makes a line with the prefix `what`: "sphere20: ".
    explicit ProgressLine(std::string what = "");
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(int done, int total);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point last_ = Clock::now();
};

}  // namespace kerf::app
