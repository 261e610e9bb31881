#pragma once

#include <csignal>

namespace kerf::app {

/// During its lifetime Ctrl+C (SIGINT) and SIGTERM don't end this program but request a stop, so
/// that it can report and keep what was done. One at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Whether a stop was requested since it was made.
    static bool requested();

  private:
    struct sigaction earlierInterrupt_ {};
    struct sigaction earlierTerminate_ {};
};

}  // namespace kerf::app
