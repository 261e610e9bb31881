#pragma once

#include <string>
#include <vector>

#include "ui/state/action.h"
#include "ui/state/pieces_state.h"

namespace kerf::ui {

/// Draws a row per piece: an eye that hides it, its colour, triangles, volume and share of its rest
/// volume. Hovered rows return an action, clicked ones frame their piece.
void drawPieces(const PiecesState& pieces, const DisplaySettings& display,
                std::vector<Action>& actions);
/// The height [px] in which drawPieces() shows all rows without scrolling, in the current window.
float piecesHeight(const PiecesState& pieces, const DisplaySettings& display);

/// A volume [m^3] in a suitable unit: "4.19 m³", "12.3 l", "0.52 ml".
std::string volumeText(double volume);

}  // namespace kerf::ui
