#include "app/cli/compare_verb.h"

#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/exit_codes.h"
#include "app/files/file_io.h"
#include "render/scene/image.h"

namespace kerf::app {
namespace {

using render::Image;
using render::ImageDifference;

void printJson(const ImageDifference& difference, bool equal, double threshold, std::ostream& out) {
    const nlohmann::ordered_json report = {{"equal", equal},
                                           {"same_size", difference.sameSize},
                                           {"mean_error", difference.meanError},
                                           {"max_error", difference.maxError},
                                           {"differing_pixels", difference.differingPixels},
                                           {"threshold", threshold}};
    out << report.dump() << '\n';
}

void printLine(const Image& a, const Image& b, const ImageDifference& difference, bool equal,
               double threshold, std::ostream& out) {
    if (!difference.sameSize) {
        out << "differ in size: " << a.width << "x" << a.height << " and " << b.width << "x"
            << b.height << '\n';
        return;
    }
    out << (equal ? "equal" : "differ") << ": mean " << difference.meanError << ", max "
        << difference.maxError << ", " << difference.differingPixels << " pixels, threshold "
        << threshold << '\n';
}

}  // namespace

int compareVerb(const CompareArguments& arguments, std::ostream& out) {
    const Image a = readPicture(arguments.a);
    const Image b = readPicture(arguments.b);
    const ImageDifference difference = render::compareImages(a, b);
    const bool equal = difference.sameSize && difference.meanError <= arguments.threshold;
    if (!equal && !arguments.diff.empty() && difference.sameSize) {
        writePicture(difference.picture, arguments.diff);
    }
    if (arguments.json) {
        printJson(difference, equal, arguments.threshold, out);
    } else {
        printLine(a, b, difference, equal, arguments.threshold, out);
    }
    return equal ? kExitDone : kExitCheckFailed;
}

}  // namespace kerf::app
