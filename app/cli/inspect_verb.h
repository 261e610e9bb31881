#pragma once

#include <filesystem>
#include <iosfwd>

namespace kerf::app {

/// The arguments of `kerf inspect MODEL [--json | --pieces]`, parsed.
struct InspectArguments {
    std::filesystem::path model;  ///< a file, or the name of a builtin model
    bool json = false;
    bool pieces = false;  ///< a table of the pieces as CSV instead
};

/// Prints on `out` what the model is and whether it can be cut. Throws InputError where it can't be
/// read, and, the report printed, where it can't be cut. Returns the exit code 0 otherwise.
int inspectVerb(const InspectArguments& arguments, std::ostream& out);

}  // namespace kerf::app
