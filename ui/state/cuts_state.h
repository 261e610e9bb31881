#pragma once

#include <string>
#include <vector>

#include "sim/cut/subdivision_pattern.h"
#include "ui/state/cut_rows.h"

namespace kerf::ui {

/// The quality of the cuts.
struct CutsState {
    std::vector<CutRow> rows;
    std::string note;                  ///< about them; may be empty
    SubdivisionCounts subdivisions{};  ///< of the surface, since the body was whole
};

}  // namespace kerf::ui
