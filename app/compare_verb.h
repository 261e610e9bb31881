#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

namespace kerf::app {

/// `kerf compare A.png B.png [--threshold T] [--diff D.png] [--json]`, parsed.
struct CompareArguments {
    std::filesystem::path a;
    std::filesystem::path b;
    double threshold = 0;  ///< largest mean channel difference that still passes, 0 to 1
    std::optional<std::filesystem::path> diff;  ///< written only when the pictures differ
    bool json = false;
};

/// Prints one line (or one JSON object) about the two pictures on `out`. Returns the exit code:
/// 0 within the threshold, 1 they differ (in size too), 3 a picture can't be read, 5
/// the difference can't be written (one sentence on `errors`).
int compareVerb(const CompareArguments& arguments, std::ostream& out, std::ostream& errors);

}  // namespace kerf::app
