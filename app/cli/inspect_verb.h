#pragma once

#include <filesystem>
#include <iosfwd>

#include "app/cli/picture_size.h"

namespace kerf::app {

/// The arguments of `kerf inspect`, parsed.
struct InspectArguments {
    std::filesystem::path model;  ///< a file, or the name of a builtin model
    bool json = false;
    bool pieces = false;             ///< a table of the pieces as CSV instead
    std::filesystem::path repaired;  ///< where a repaired model is written; empty for nowhere
    std::filesystem::path remeshed;  ///< the same, with even triangles
    std::filesystem::path picture;   ///< where a picture with its faults goes; empty for nowhere
    PictureSize pictureSize;
    double edge = 0;  ///< of these, in the file's unit; 0: as proposed
};

/// Prints on `out` what the model is and whether it can be cut; of one that is repaired or
/// remeshed, what became of it. Throws InputError where it can't be read, and, the report printed,
/// where it can't be cut, OutputError where a file can't be written. Returns the exit code 0
/// otherwise.
int inspectVerb(const InspectArguments& arguments, std::ostream& out);

}  // namespace kerf::app
