#pragma once

#include "sim/base/placement.h"

namespace kerf::app {

/// The units stated by a file.
struct FileUnits {
    LengthUnit unit = LengthUnit::metre;
    UpAxis up = UpAxis::y;
};

/// The contents of a model file besides its surface.
struct FileFacts {
    std::vector<std::string> objects{};  ///< names of the disconnected ones, in its order
    std::optional<FileUnits> units{};    ///< none if not stated

    template <class Io>
    void archive(Io& io) {
        io(objects, units);
    }
};

/// The likely meaning of the numbers of a model file.
struct UnitGuess {
    LengthUnit unit = LengthUnit::metre;
    UpAxis up = UpAxis::y;
    bool certain = false;  ///< the file or its format says so
    std::string sentence;  ///< the choice and its reason, for people
};

/// The units stated by the file; else a guess by its format and by the size of the model, where
/// `own` are the bounds of its numbers: of the format's usual units the first that makes the model
/// neither tiny nor huge.
UnitGuess guessUnits(const std::filesystem::path& file, const Bounds& own,
                     const std::optional<FileUnits>& said);

/// The bounds of a model in the scene [m].
Bounds placedBounds(std::span<const Vec3> own, const Placement& placement);

/// The placement of an opened model with the points `own`: unit and axis as guessed, over the
/// origin of the scene, with its shape and size.
Placement standing(const UnitGuess& guess, std::span<const Vec3> own);
/// The placement, moved so that the model's middle is over `ground` [m], a point of the floor, and
/// its lowest point a fiftieth of its diagonal above.
Placement standing(Placement placement, std::span<const Vec3> own, const Vec3& ground);

}  // namespace kerf::app
