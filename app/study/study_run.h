#pragma once

#include "app/files/io/system_file.h"
#include "app/study/run_record.h"

namespace kerf::app {

/// The end of a run of a study.
struct RunEnd {
    RunRecord record;
    bool wasDone = false;   ///< it was done before, and not run again
    std::string log;        ///< the end of what it wrote to standard error
    bool noOpenGl = false;  ///< without usable OpenGL: nothing is recorded
};

/// Runs one run of a study as a replay in a separate process, unless it is done. The results appear
/// as the folder of the run, complete, with its record, replacing earlier results. Waits while
/// another program does the same run. Throws OutputError, also if the run's folder holds something
/// other than a run.
RunEnd performRun(const Study& study, std::size_t number, const std::filesystem::path& out);

/// A lock on one run of a study, so that only one of several programs that share its folder, on one
/// or more machines, runs it at a time. The system releases it when its holder ends. On a file
/// system without locks it does nothing.
class RunLock {
  public:
    /// Waits until the run is free. The lock is a hidden file of `out`, which must exist. Throws
    /// OutputError if that can't be opened.
    RunLock(const std::filesystem::path& out, std::size_t number);
    ~RunLock();
    /// Throws OutputError if that file can't be opened.
    static void requireFile(const std::filesystem::path& out);
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

  private:
    Descriptor file_;
    std::size_t number_;
};

}  // namespace kerf::app
