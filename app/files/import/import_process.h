#pragma once

#include "app/files/jobs/background_job.h"
#include "app/files/jobs/child_process.h"

namespace kerf::app {

/// Resource limits of a program that reads a file; kMendingWallSeconds and allowMending() once it
/// is read. The defaults suffice for a real model of the largest size.
struct ImportLimits {
    int cpuSeconds = 20;
    int wallSeconds = 30;
    std::uint64_t addressSpace = 4ull << 30;  ///< [bytes]
};

/// The end of a program that reads a file. Its answer is complete only if it exited with 0.
struct ImportEnd : ChildEnd {
    std::string answer;    ///< what it wrote to standard output
    std::string log;       ///< the beginning of what it wrote to standard error, without stages
    std::string stage;     ///< what it did last, once the file was read; empty before
    bool tooSlow = false;  ///< it reached the limit of CPU or wall time
    bool tooLong = false;  ///< the answer exceeded kMaxImportAnswer
};

/// Most bytes of an answer: more than a model of the largest size needs.
inline constexpr std::uint64_t kMaxImportAnswer = 8ull << 30;
/// Begins a line of standard error that tells a stage of the work.
inline constexpr char kStageMark = '\x1E';

/// Runs `command`, a program and its arguments, which applies the limits (applyImportLimits()) and
/// answers on standard output. It inherits no open files, and is killed when the wall time is over.
/// Its stages go to `progress`. Throws InputError if it can't be started, WorkCancelled soon after
/// `progress` was cancelled; then it has ended.
ImportEnd runImportProcess(const std::vector<std::string>& command, const ImportLimits& limits,
                           WorkProgress* progress = nullptr);

}  // namespace kerf::app
