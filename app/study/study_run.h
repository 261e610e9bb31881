#pragma once

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

}  // namespace kerf::app
