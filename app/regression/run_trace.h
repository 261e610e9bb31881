#pragma once

#include "sim/base/math.h"

namespace kerf::app {

/// The counts and the volume after a step.
struct TraceRow {
    double volume = 0;  ///< [m^3]
    int pieces = 0;
    int vertices = 0;
    int triangles = 0;
};
/// The counts of each step of a run.
using RunTrace = std::vector<TraceRow>;

/// A piece after a step.
struct PieceBox {
    double volume = 0;  ///< [m^3]
    Bounds box;         ///< [m]
};
/// The pieces after some steps, by step.
using PieceTrace = std::map<int, std::vector<PieceBox>>;

/// Reads the columns step, volume, pieces, vertices and triangles of a metrics.csv or course.csv.
/// Throws InputError naming file and line, like readPieces().
RunTrace readTrace(const std::filesystem::path& file);
/// The text of a course.csv.
std::string formatTrace(const RunTrace& trace);

/// Reads a pieces.csv, whole or thinned out.
PieceTrace readPieces(const std::filesystem::path& file);
/// The text of a pieces.csv with these steps.
std::string formatPieces(const PieceTrace& pieces);
/// Some thirty steps of a run, evenly spaced, the last one among them.
PieceTrace thinnedOut(const PieceTrace& pieces);

/// The last of these steps; -1 for none.
int lastStepOf(const PieceTrace& pieces);

}  // namespace kerf::app
