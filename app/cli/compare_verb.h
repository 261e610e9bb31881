#pragma once

#include <filesystem>
#include <iosfwd>

namespace kerf::app {

/// The arguments of `kerf compare A.png B.png [--threshold T] [--diff D.png] [--json]`, parsed.
struct CompareArguments {
    std::filesystem::path a;
    std::filesystem::path b;
    double threshold = 0;        ///< largest mean channel difference that still passes, 0 to 1
    std::filesystem::path diff;  ///< written only when the pictures differ; empty for none
    bool json = false;
};

/// Prints one line (or one JSON object) about the two pictures on `out`. Returns the exit code:
/// 0 within the threshold, 1 where they differ (in size too). Throws InputError where a picture
/// can't be read, OutputError where the difference can't be written.
int compareVerb(const CompareArguments& arguments, std::ostream& out);

}  // namespace kerf::app
