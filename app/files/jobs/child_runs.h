#pragma once

#include "app/files/jobs/background_job.h"
#include "app/files/jobs/child_process.h"

namespace kerf::app {

/// The end of a program that ran as a child of this one.
struct ChildOutcome : ChildEnd {
    std::string log;     ///< the end of what it wrote to standard error
    double seconds = 0;  ///< wall clock
};

/// Runs this program once for each of `runs`, which are its arguments, at most `jobs` at a time.
/// Calls `done` with the number of a run and its end, one at a time, in the order of ending.
/// Children read nothing, their standard output is dropped, and they end with this process. After a
/// request to stop (Interruption) no further ones are started. Throws OutputError if a child can't
/// be started, and what `done` throws, after the others have ended.
void runChildren(const std::vector<std::vector<std::string>>& runs, int jobs,
                 const std::function<void(std::size_t run, const ChildOutcome& outcome)>& done);

/// Runs this program once and calls `lines`, unless it is null, after each of its lines on standard
/// output with their number. Throws WorkCancelled soon after `progress` was cancelled, once the
/// child has ended, and OutputError if it can't be started.
ChildOutcome runChild(const std::vector<std::string>& arguments, const WorkProgress& progress,
                      const std::function<void(int count)>& lines);

/// A path as an argument that can't be taken for an option.
std::string asArgument(const std::filesystem::path& path);

/// The last line of a child's log, without the program's name; "" for none.
std::string lastWords(const ChildOutcome& outcome);

/// The end of a child in one clause: "ended by signal 11", "exit code 3: <its last line>".
std::string sentenceAbout(const ChildOutcome& outcome);
/// That clause without the name of the temporary folder that the child worked in.
std::string sentenceAbout(const ChildOutcome& outcome, const std::filesystem::path& folder);

}  // namespace kerf::app
