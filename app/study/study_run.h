#pragma once

#include <filesystem>

#include "app/study/run_record.h"

namespace kerf::app {

/// The end of a run of a study.
struct RunEnd {
    RunRecord record;
    bool wasDone = false;   ///< it had been run before, and was not run again
    std::string log;        ///< the end of what it wrote to standard error
    bool noOpenGl = false;  ///< it found no usable OpenGL: nothing is recorded then
};

/// Runs one run of a study as a replay in a process of its own, unless it is done. The results
/// appear as the folder of the run, complete, with its record; results of an earlier run there are
/// replaced. Waits while another program does the same run. Throws OutputError, also where the
/// run's folder holds something else than a run.
RunEnd performRun(const Study& study, std::size_t number, const std::filesystem::path& out);

}  // namespace kerf::app
