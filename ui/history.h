#pragma once

#include <array>
#include <vector>

#include "ui/plot_math.h"
#include "ui/series.h"

namespace kerf::ui {

/// Stages of a step, and of a picture.
enum class Stage { deform, collide, cut, render, frame };
inline constexpr int kStages = 5;

/// Pieces whose volumes the plots follow: the first ones.
inline constexpr int kPlottedPieces = 8;

/// What the plots show, against simulated time [s].
struct History {
    Series framesPerSecond;
    std::array<Series, kStages> stages;  ///< by Stage [ms]
    Series volumePercent;                ///< of the uncut rest shape
    std::vector<Series> piecePercent;    ///< of the rest volume of each, at most kPlottedPieces
    Series kineticEnergy;                ///< [J]
    Series potentialEnergy;              ///< [J]
    Series strainEnergy;                 ///< [J]; nothing with plain PBD
    Series totalEnergy;                  ///< the sum of those there are [J]
    Series touchedTriangles;
    Series lostPieces;            ///< taken back since the start, where there were any
    std::vector<PlotMark> marks;  ///< cuts, impacts, what was undone, by time
};

}  // namespace kerf::ui
