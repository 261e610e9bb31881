#pragma once

#include <csignal>

namespace kerf::app {

/// While it lives, Ctrl+C (SIGINT) and SIGTERM don't end this program but ask it to stop, so that
/// it can tell and keep what was done. One at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Whether somebody asked to stop since it was made.
    static bool requested();

  private:
    struct sigaction earlierInterrupt_ {};
    struct sigaction earlierTerminate_ {};
};

}  // namespace kerf::app
