#pragma once

#include "app/study/run_record.h"

namespace kerf::app {

inline constexpr const char* kTableFile = "table.csv";

/// The results of the runs of a study.
struct StudyTable {
    std::string text;                    ///< of table.csv, a row for each run
    std::vector<std::size_t> failed;     ///< runs with an exit code other than 0
    std::vector<std::size_t> missing;    ///< runs without results, or with those of another run
    std::vector<std::string> warnings;   ///< a sentence for each run with invalid results
    std::vector<std::string> renderers;  ///< of the runs, each once
};

/// Gathers the results in `out`. Missing ones are empty cells.
StudyTable gatherTable(const Study& study, const std::filesystem::path& out);

}  // namespace kerf::app
