#pragma once

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

}  // namespace kerf::gpu
