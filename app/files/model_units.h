#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "sim/base/placement.h"

namespace kerf::app {

/// What the numbers of a model file mean, as far as can be told.
struct UnitGuess {
    LengthUnit unit = LengthUnit::metre;
    UpAxis up = UpAxis::y;
    bool certain = false;  ///< the format says so
    std::string sentence;  ///< what was taken, and why: for people
};

/// Guesses by the file's format and by the size of the model, where `own` are the bounds of its
/// numbers. Of the units that the format is used with, the first that makes the model neither tiny
/// nor huge.
UnitGuess guessUnits(const std::filesystem::path& file, const Bounds& own);

/// The placement of an opened model, whose points in its own numbers are `own`: unit and axis as
/// guessed, over the origin of the scene. Nothing of its shape or size is changed.
Placement standing(const UnitGuess& guess, std::span<const Vec3> own);
/// The placement, moved so that the model stands over `ground` [m], a point of the floor: its
/// middle over that, its lowest point a fiftieth of its diagonal above.
Placement standing(Placement placement, std::span<const Vec3> own, const Vec3& ground);

}  // namespace kerf::app
