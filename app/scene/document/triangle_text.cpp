#include "app/scene/document/triangle_text.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/quantity_text.h"
#include "sim/base/text.h"

namespace kerf::app {

std::string trianglesText(const TriangleFigures& figures) {
    std::string text = counted(figures.triangles, "triangle", "triangles");
    if (figures.needles > 0) {
        text += fmt::format(", {} of them {}", figures.needles,
                            figures.needles == 1 ? "a needle" : "needles");
    }
    return text + fmt::format("; edges of {} to {}, {} in the mean.",
                              lengthText(figures.shortestEdge), lengthText(figures.longestEdge),
                              lengthText(figures.meanEdge()));
}

std::string coarseText(const TriangleFigures& figures, const std::string& longestEdge) {
    return fmt::format("The skin is coarse: {}, edges up to {}",
                       counted(figures.triangles, "triangle", "triangles"), longestEdge);
}

}  // namespace kerf::app
