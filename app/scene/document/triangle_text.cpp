#include "app/scene/document/triangle_text.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"

namespace kerf::app {

std::string trianglesText(const TriangleFigures& figures) {
    std::string text = counted(figures.triangles, "triangle", "triangles");
    if (figures.needles > 0) {
        text += ", " + counted(figures.needles, "sliver", "slivers");
    }
    return text + fmt::format("; edge length {} to {}, mean {}", lengthText(figures.shortestEdge),
                              lengthText(figures.longestEdge), lengthText(figures.meanEdge()));
}

std::string coarseText(const TriangleFigures& figures, const std::string& longestEdge) {
    return fmt::format("The mesh is coarse: {}, edges up to {}",
                       counted(figures.triangles, "triangle", "triangles"), longestEdge);
}

}  // namespace kerf::app
