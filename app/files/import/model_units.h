#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/base/placement.h"

namespace kerf::app {

/// What a file itself says of its numbers.
struct FileUnits {
    LengthUnit unit = LengthUnit::metre;
    UpAxis up = UpAxis::y;
};

/// What a model file says besides its surface.
struct FileFacts {
    std::vector<std::string> objects{};  ///< names of those that don't hang together, in its order
    std::optional<FileUnits> units{};    ///< none where it says nothing of them
};

/// What the numbers of a model file mean, as far as can be told.
struct UnitGuess {
    LengthUnit unit = LengthUnit::metre;
    UpAxis up = UpAxis::y;
    bool certain = false;  ///< the file or its format says so
    std::string sentence;  ///< what was taken, and why: for people
};

/// What the file says, if it says something; else guesses by its format and by the size of the
/// model, where `own` are the bounds of its numbers. Of the units that the format is used with, the
/// first that makes the model neither tiny nor huge.
UnitGuess guessUnits(const std::filesystem::path& file, const Bounds& own,
                     const std::optional<FileUnits>& said);

/// Where points of a model lie in the scene [m].
Bounds placedBounds(std::span<const Vec3> own, const Placement& placement);

/// The placement of an opened model, whose points in its own numbers are `own`: unit and axis as
/// guessed, over the origin of the scene. Nothing of its shape or size is changed.
Placement standing(const UnitGuess& guess, std::span<const Vec3> own);
/// The placement, moved so that the model stands over `ground` [m], a point of the floor: its
/// middle over that, its lowest point a fiftieth of its diagonal above.
Placement standing(Placement placement, std::span<const Vec3> own, const Vec3& ground);

}  // namespace kerf::app
