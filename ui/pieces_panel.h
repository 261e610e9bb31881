#pragma once

#include <string>
#include <vector>

#include "ui/action.h"
#include "ui/piece_row.h"

namespace kerf::ui {

/// What the list of pieces shows.
struct PiecesState {
    std::vector<PieceRow> rows;
    int hovered = -1;  ///< of rows; -1 for none
};

/// Draws a row per piece: an eye that hides it, its colour, triangles, volume and share of its rest
/// volume. Hovered rows answer, clicked ones bring their piece into view.
void drawPieces(const PiecesState& pieces, const DisplaySettings& display,
                std::vector<Action>& actions);
/// The height [px] in which drawPieces() shows all rows without scrolling, in the current window.
float piecesHeight(const PiecesState& pieces, const DisplaySettings& display);

/// A volume [m^3] in the unit that suits it: "4.19 m³", "12.3 l", "0.52 ml".
std::string volumeText(double volume);

}  // namespace kerf::ui
