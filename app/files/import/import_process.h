#pragma once

#include "app/files/jobs/background_job.h"
#include "app/files/jobs/child_process.h"

namespace kerf::app {

/// Resource limits of a reader process. The defaults suffice for a real model of the largest size.
struct ImportLimits {
    int cpuSeconds = 20;
    int wallSeconds = 30;
    std::uint64_t addressSpace = 4ull << 30;  ///< [bytes]
};

/// The end of a reader process. Its answer is complete only if it exited with 0.
struct ImportOutcome : ChildEnd {
    std::string answer;    ///< what it wrote to standard output
    std::string log;       ///< the beginning of what it wrote to standard error
    bool tooSlow = false;  ///< it reached the limit of CPU or wall time
    bool tooLong = false;  ///< the answer exceeded kMaxImportAnswer
};

/// Called with the first kImportHeadBytes of an answer; may throw to end the reading.
using ImportHeadListener = std::function<void(std::string_view head)>;

/// Runs `program import-worker file` and collects its output. The child inherits no open files, and
/// is killed when the wall time is over. Throws InputError if it can't be started, WorkCancelled
/// soon after `progress` was cancelled, and what `onHead` throws; then the child has ended.
ImportOutcome runImportProcess(const std::filesystem::path& program,
                               const std::filesystem::path& file, const ImportLimits& limits,
                               const WorkProgress* progress = nullptr,
                               const ImportHeadListener& onHead = nullptr);

/// Runs any program that keeps to such limits (applyImportLimits) and answers on standard output.
/// `command`: its path and its arguments.
ImportOutcome runLimitedProcess(const std::vector<std::string>& command, const ImportLimits& limits,
                                const WorkProgress* progress = nullptr,
                                const ImportHeadListener& onHead = nullptr);

/// The hidden verb of the child process: reads `file`, writes the triangles to standard output.
int runImportWorker(const std::filesystem::path& file);
/// The answer of the child (import_protocol.h), made in this process: a crash of the reader ends
/// this one.
std::string answerFor(const std::filesystem::path& file);

}  // namespace kerf::app
