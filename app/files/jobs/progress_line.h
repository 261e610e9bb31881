#pragma once

#include "sim/base/stopwatch.h"

namespace kerf::app {

/// "step 30 of 120 (25 %), about 2 min left", by the rate of the `seconds` so far.
std::string progressText(int done, int total, double seconds);

/// A line on the terminal that is overwritten and removed at the end; nothing if standard error is
/// no terminal.
class ProgressLine {
  public:
    /// Makes a line with the prefix `what`: "sphere20: ".
    explicit ProgressLine(std::string what = "");
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Its clock starts with the first call.
    void show(int done, int total);

  private:
    std::string what_;
    bool terminal_;
    std::optional<Stopwatch> watch_;  ///< since the first call
    bool shown_ = false;
    double last_ = 0;  ///< when it was written [s]
};

}  // namespace kerf::app
