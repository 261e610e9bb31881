#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/base/math.h"

namespace kerf::app {

/// The counts and the volume after a step.
struct CourseRow {
    double volume = 0;  ///< [m^3]
    int pieces = 0;
    int vertices = 0;
    int triangles = 0;
};
/// The counts of each step of a run.
using Course = std::vector<CourseRow>;

/// A piece after a step.
struct PieceBox {
    double volume = 0;  ///< [m^3]
    Bounds box;         ///< [m]
};
/// The pieces after some steps, by step.
using PieceCourse = std::map<int, std::vector<PieceBox>>;

/// Reads the columns step, volume, pieces, vertices and triangles of a metrics.csv or course.csv.
/// Throws InputError naming file and line, like readPieces().
Course readCourse(const std::filesystem::path& file);
/// The text of a course.csv.
std::string formatCourse(const Course& course);

/// Reads a pieces.csv, whole or thinned out.
PieceCourse readPieces(const std::filesystem::path& file);
/// The text of a pieces.csv with these steps.
std::string formatPieces(const PieceCourse& pieces);
/// Some thirty steps of a run, evenly spaced, the last one among them.
PieceCourse thinnedOut(const PieceCourse& pieces);

/// The last of these steps; -1 for none.
int lastStepOf(const PieceCourse& pieces);

/// The box around all pieces.
Bounds boxAround(const std::vector<PieceBox>& pieces);

}  // namespace kerf::app
