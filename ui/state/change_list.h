#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kerf::ui {

/// One row of the history: something that can be taken back or brought back.
struct ChangeRow {
    std::string name;
    double time = 0;  ///< simulated, when it happened [s]
};

/// The changes that can be taken back.
struct ChangeList {
    std::vector<ChangeRow> rows;  ///< oldest first
    std::size_t done = 0;         ///< so many of them are in force, the others undone
    int forgotten = 0;            ///< older ones that had to go
    std::size_t bytes = 0;
    std::size_t budget = 0;  ///< [bytes]
};

}  // namespace kerf::ui
