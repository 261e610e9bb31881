#pragma once

#include <cstdint>

#include "ui/measures.h"

namespace kerf::ui {

/// The tool of the left button in the view: it leads a blade in one of three ways, or touches the
/// body.
enum class Tool : std::uint8_t {
    stroke,      ///< along the line of sight, wherever the pointer goes
    scalpel,     ///< upright on the surface under the pointer: incisions
    guillotine,  ///< posed by handles and brought straight down
    grab,        ///< pulls at the body
    pin,         ///< holds parts of the body in place, or frees them
    measure,     ///< tells distances, angles, areas and volumes by clicks
};
inline constexpr int kTools = 6;

/// The settings of all tools, which the tools panel shows and answers with. Lengths in metres.
struct ToolSettings {
    Tool tool = Tool::stroke;
    bool throughAll = true;     ///< the stroke's blade reaches beyond the body
    double strokeDepth = 0.3;   ///< how far behind the nearest point of the body it ends otherwise
    double scalpelDepth = 0.1;  ///< below the surface
    double length = 1;          ///< of the guillotine
    double drop = 1;            ///< how far it goes down
    double lowered = 0;         ///< share of that, 0 to 1
    double grabRadius = 0.1;    ///< of what the hand takes hold of
    double pinRadius = 0.1;     ///< of the brush
    MeasureKind measure = MeasureKind::distance;
    double longest = 3;  ///< end of all sliders
    bool operator==(const ToolSettings&) const = default;
};

}  // namespace kerf::ui
