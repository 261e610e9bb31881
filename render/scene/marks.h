#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/scene/overlays.h"

namespace kerf::render {

/// Lines and dots of one colour over a body, such as one kind of fault of its model. Hidden ones
/// are fainter.
struct Marks {
    std::string label;  ///< what they are, for the legend: "12 open edges"
    DisplayColor color{};
    std::vector<std::uint32_t> lines;  ///< pairs of vertices of the body
    std::vector<std::uint32_t> dots;   ///< vertices of the body
};

}  // namespace kerf::render
