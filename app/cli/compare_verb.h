#pragma once

#include <iosfwd>

#include "render/scene/picture_comparison.h"

namespace kerf::app {

/// The arguments of `kerf compare A.png B.png [--threshold T] [--tolerant] [--mask X,Y,W,H]...
/// [--diff D.png] [--json]`, parsed.
struct CompareArguments {
    std::filesystem::path a;
    std::filesystem::path b;
    /// Largest mean channel difference that still passes, 0 to 1; without it the limits decide.
    std::optional<double> threshold;
    bool tolerant = false;                 ///< kTolerantLimits instead of kStrictLimits
    std::vector<render::PixelRect> masks;  ///< left out
    std::filesystem::path diff;            ///< written only if the pictures differ; empty for none
    bool json = false;
};

/// The rectangle that a text such as "10,20,300,40" names: x and y of its upper left corner, width
/// and height, all in whole pixels, the latter two at least 1. Empty for other texts.
std::optional<render::PixelRect> readMask(const std::string& text);

/// Prints one line (or one JSON object) about the two pictures on `out`. Returns the exit code: 0
/// within the limits or the threshold, 1 if they differ (in size too). Throws InputError if a
/// picture can't be read or the masks don't fit it, OutputError if the difference picture can't be
/// written.
int runCompare(const CompareArguments& arguments, std::ostream& out);

}  // namespace kerf::app
