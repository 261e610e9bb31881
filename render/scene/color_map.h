#pragma once

#include <array>

#include "render/scene/overlays.h"

namespace kerf::render {

/// Colours for numbers, at equal distances from the lowest to the highest, straight lines between.
using ColorMap = std::array<DisplayColor, 11>;

/// Viridis by van der Walt and Smith (matplotlib, CC0), in eleven of its 256 colours: even steps
/// look even, in grey too. For what begins at 0.
inline constexpr ColorMap kViridis{{{68, 1, 84},
                                    {72, 37, 118},
                                    {65, 68, 135},
                                    {53, 96, 141},
                                    {42, 120, 142},
                                    {33, 144, 140},
                                    {34, 168, 132},
                                    {67, 191, 113},
                                    {122, 209, 81},
                                    {187, 223, 39},
                                    {253, 231, 37}}};
/// RdBu of ColorBrewer (Brewer and Harrower, colorbrewer2.org) from blue to red: pale in the
/// middle, told apart with any colour blindness. For what has a sign.
inline constexpr ColorMap kBlueRed{{{5, 48, 97},
                                    {33, 102, 172},
                                    {67, 147, 195},
                                    {146, 197, 222},
                                    {209, 229, 240},
                                    {247, 247, 247},
                                    {253, 219, 199},
                                    {244, 165, 130},
                                    {214, 96, 77},
                                    {178, 24, 43},
                                    {103, 0, 31}}};

}  // namespace kerf::render
