#pragma once

#include <sys/types.h>

namespace kerf::gpu {

/// While one exists, threads of this process that wait for each other stay awake for a moment, in
/// which others may run, before they sleep. llvmpipe sends its threads to sleep after each kernel:
/// to wake them takes as long as a small kernel runs, so that a second processor gains nothing.
/// Only in programs, not in the Python module, whose host comes before it.
class PromptWaits {
  public:
    /// `needed`: if false, it does nothing, as for drivers that don't compute on processors.
    explicit PromptWaits(bool needed);
    ~PromptWaits();
    PromptWaits(const PromptWaits&) = delete;
    PromptWaits& operator=(const PromptWaits&) = delete;

  private:
    bool needed_;
};

/// Processors that this process may use, ascending.
std::vector<int> processors();
/// Keeps a thread on a processor; 0: the calling one.
void moveThread(pid_t thread, int processor);

/// Puts the threads of llvmpipe on a processor each, where it has one for every processor that this
/// process may use: else two of them may share one for seconds while another idles. Without other
/// drivers' threads it does nothing.
void spreadDriverThreads();

}  // namespace kerf::gpu
