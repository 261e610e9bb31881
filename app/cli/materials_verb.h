#pragma once

#include <iosfwd>
#include <string>

namespace kerf::app {

/// The arguments of `kerf materials [NAME|FILE] [--json]`, parsed.
struct MaterialsArguments {
    std::string material;  ///< a builtin name or a file; empty for the list
    bool json = false;
};

/// Prints the materials that come with Kerf on `out`, a line each; or one with its values, spread
/// and sources. Returns the exit code. Throws InputError.
int materialsVerb(const MaterialsArguments& arguments, std::ostream& out);

}  // namespace kerf::app
