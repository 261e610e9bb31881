#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kerf::app {

/// A screenshot of a run that differs from its reference.
struct ReferenceDifference {
    std::string file;
    bool missingInRun = false;
    std::string sentence;  ///< one, that says how it differs
};

/// Compares screenshots in the folder of a run with those of the same names in a folder of
/// references, by the limits of kerf compare, and writes a picture of each difference into
/// `run`/diff. Throws InputError if a picture can't be read, OutputError.
std::vector<ReferenceDifference> compareWithReference(const std::vector<std::string>& files,
                                                      const std::filesystem::path& reference,
                                                      const std::filesystem::path& run);

/// Copies differing pictures of the run into the folder of references. Returns their names. Throws
/// OutputError.
std::vector<std::string> renewReference(const std::vector<ReferenceDifference>& differences,
                                        const std::filesystem::path& reference,
                                        const std::filesystem::path& run);

}  // namespace kerf::app
