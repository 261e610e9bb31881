#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study/run_record.h"

namespace kerf::app {

inline constexpr const char* kTableFile = "table.csv";

/// The results of the runs of a study.
struct StudyTable {
    std::string text;                    ///< of table.csv, a row for each run
    std::vector<std::size_t> failed;     ///< runs that ended with another exit code than 0
    std::vector<std::size_t> missing;    ///< runs without results, or with those of another run
    std::vector<std::string> warnings;   ///< a sentence for each run whose results don't count
    std::vector<std::string> renderers;  ///< on which the runs were made, each once
};

/// Gathers the results that lie in `out`. What a run has not got is an empty cell.
StudyTable gatherTable(const Study& study, const std::filesystem::path& out);

}  // namespace kerf::app
