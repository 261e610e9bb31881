#pragma once

#include <cstdint>

namespace kerf::ui {

/// How the pointer leads the blade.
enum class BladeTool : std::uint8_t {
    stroke,      ///< along the line of sight, wherever the pointer goes
    scalpel,     ///< upright on the surface under the pointer: incisions
    guillotine,  ///< posed by handles and brought straight down
};

/// What the blade panel shows and answers with. Lengths in metres.
struct BladeSettings {
    BladeTool tool = BladeTool::stroke;
    bool throughAll = true;     ///< the stroke's blade reaches beyond the body
    double strokeDepth = 0.3;   ///< how far behind the nearest point of the body it ends otherwise
    double scalpelDepth = 0.1;  ///< below the surface
    double length = 1;          ///< of the guillotine
    double drop = 1;            ///< how far it goes down
    double lowered = 0;         ///< share of that, 0 to 1
    double longest = 3;         ///< end of all sliders
    bool operator==(const BladeSettings&) const = default;
};

}  // namespace kerf::ui
