#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/jobs/child_runs.h"
#include "app/files/jobs/work_progress.h"

namespace kerf::app {

/// Limits of what a reader process may use. The defaults leave a real model of the largest size
/// room.
struct ImportLimits {
    int cpuSeconds = 20;
    int wallSeconds = 30;
    std::uint64_t addressSpace = 4ull << 30;  ///< [bytes]
};

/// The end of a reader process. Its answer is complete only where it exited with 0.
struct ImportOutcome : ChildEnd {
    std::string answer;    ///< what it wrote to standard output
    std::string log;       ///< the beginning of what it wrote to standard error
    bool tooSlow = false;  ///< it ran into the CPU or the wall limit
    bool tooLong = false;  ///< the answer ran past kMaxImportAnswer
};

/// Told how an answer begins, kImportHeadBytes of it, before more is taken; may throw to end the
/// reading.
using ImportHeadListener = std::function<void(std::string_view head)>;

/// Runs `program import-worker file` and collects what it says. The child inherits no open files,
/// and is killed when the wall time is over. Throws InputError where it can't be started,
/// WorkCancelled soon after `progress` was cancelled, and what `onHead` throws; the child is gone
/// then.
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
/// The answer of the child (import_protocol.h), which it makes in this process: a reader that
/// crashes on the file takes this down.
std::string answerFor(const std::filesystem::path& file);

}  // namespace kerf::app
