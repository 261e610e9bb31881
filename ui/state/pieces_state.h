#pragma once

#include <vector>

#include "ui/state/piece_row.h"

namespace kerf::ui {

/// What the list of pieces shows.
struct PiecesState {
    std::vector<PieceRow> rows;
    int hovered = -1;  ///< of rows; -1 for none
};

}  // namespace kerf::ui
