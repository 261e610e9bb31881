#pragma once

#include <filesystem>
#include <iosfwd>

#include "app/cli/picture_size.h"
#include "app/files/import/mending.h"

namespace kerf::app {

/// The arguments of `kerf inspect`, parsed.
struct InspectArguments {
    std::filesystem::path model;  ///< a file, or the name of a builtin model
    bool json = false;
    bool pieces = false;            ///< a table of the pieces as CSV instead
    std::filesystem::path mended;   ///< where a mended model is written; empty for nowhere
    Mending mending;                ///< what is done for it beside a repair, as mendModel() does it
    std::filesystem::path picture;  ///< where a picture with its faults goes; empty for nowhere
    PictureSize pictureSize;
};

/// Prints on `out` what the model is and whether it can be cut; of one that is mended,
/// what became of it. Throws InputError where it can't be read, and, the report printed,
/// where it can't be cut, OutputError where a file can't be written. Returns the exit code 0
/// otherwise.
int inspectVerb(const InspectArguments& arguments, std::ostream& out);

}  // namespace kerf::app
