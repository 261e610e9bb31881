#include "app/scene/triangle_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "sim/base/quantity_text.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

/// With two digits: an estimate.
double rounded(double count) {
    if (count < 1) {
        return 0;
    }
    const double step = std::pow(10.0, std::max(0.0, std::floor(std::log10(count)) - 1));
    return std::round(count / step) * step;
}

}  // namespace

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

std::string eveningText(const TriangleFigures& figures) {
    const double edge = evenEdge(figures);
    return fmt::format(
        "Makes about {:.0f} triangles with edges of {}, on the same surface. The scene begins "
        "anew, "
        "texture coordinates and colours of vertices are lost; undo brings all of it back",
        rounded(trianglesOf(figures, edge)), lengthText(edge));
}

}  // namespace kerf::app
