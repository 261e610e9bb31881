#include "sim/cut/cut_types.h"

namespace kerf {

const char* nameOf(SubdivisionPattern pattern) {
    switch (pattern) {
        case SubdivisionPattern::oneToFour:
            return "1-to-4";
        case SubdivisionPattern::oneToThreeA:
            return "1-to-3a";
        case SubdivisionPattern::oneToTwo:
            return "1-to-2";
        case SubdivisionPattern::oneToThreeB:
            return "1-to-3b";
        case SubdivisionPattern::twoKinks:
            return "two kinks";
        case SubdivisionPattern::twoSegments:
            return "two segments";
        case SubdivisionPattern::more:
            break;
    }
    return "more";
}

void addTo(SubdivisionCounts& sum, const SubdivisionCounts& part) {
    for (int i = 0; i < kSubdivisionPatterns; ++i) {
        sum[i] += part[i];
    }
}

int otherPatterns(const SubdivisionCounts& counts) {
    return std::accumulate(counts.begin() + kPaperPatterns, counts.end(), 0);
}

}  // namespace kerf
