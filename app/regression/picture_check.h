#pragma once

#include "app/files/io/output_folder.h"
#include "app/regression/expectation.h"

namespace kerf::app {

/// The comparison of a picture of a run with the expected one.
struct PictureCheck {
    std::string file;
    bool alike = false;
    bool missing = false;                  ///< the run did not give it
    bool unknown = false;                  ///< the folder of expectations lacks it
    render::PictureComparison comparison;  ///< without its errors by pixel
    std::string sizes;                     ///< "96x64 pixels instead of 48x32", if they differ
    std::filesystem::path difference;      ///< a picture of it; empty for none
};

/// Compares the picture in the folder `run` with that in the folder `expected`, and writes a
/// picture of the difference into `differences`. They are equal within `limits`. Throws InputError
/// if a picture can't be read, OutputError.
PictureCheck checkPicture(const ExpectedPicture& picture, const std::filesystem::path& expected,
                          const std::filesystem::path& run, OutputFolder& differences,
                          const render::PictureLimits& limits);

/// One sentence on how they differ and where most.
std::string sentenceAbout(const PictureCheck& check);

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
