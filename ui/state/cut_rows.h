#pragma once

#include <string>

namespace kerf::ui {

/// A figure of how well cuts came out.
struct CutRow {
    std::string quantity;  ///< "Smallest angle, worst"
    std::string all;       ///< of all cuts, as people read it
    std::string last;      ///< of the last stroke; empty where a stroke has none of its own
    std::string tooltip;   ///< what it means
};

}  // namespace kerf::ui
