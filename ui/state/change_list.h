#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kerf::ui {

/// One row of the history: a change that can be undone or redone.
struct ChangeRow {
    std::string name;
    double time = 0;  ///< simulated time of the change [s]
};

/// The undo history.
struct ChangeList {
    std::vector<ChangeRow> rows;  ///< oldest first
    std::size_t done = 0;         ///< number of applied ones; the others are undone
    int forgotten = 0;            ///< older ones that were dropped
    bool recallable = false;      ///< undo brings older ones back first, by playing the session
    std::size_t bytes = 0;
    std::size_t budget = 0;  ///< [bytes]
};

}  // namespace kerf::ui
