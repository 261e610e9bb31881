#pragma once

#include <array>
#include <memory>

#include "app/tools/tool.h"

namespace kerf::app {

// What makes each tool, in the file of its name.
using MakeTool = std::unique_ptr<Tool>();
MakeTool makeStrokeTool, makeScalpelTool, makeGuillotineTool, makeGrabTool, makePinTool,
    makeRetractTool, makeMoveTool, makeMeasureTool;

/// The part of a row of ui::kToolRows unknown to the panels.
struct ToolMaker {
    ui::Tool tool;
    MakeTool* make;
};
inline constexpr std::array kToolMakers{
    ToolMaker{ui::Tool::stroke, makeStrokeTool},
    ToolMaker{ui::Tool::scalpel, makeScalpelTool},
    ToolMaker{ui::Tool::guillotine, makeGuillotineTool},
    ToolMaker{ui::Tool::grab, makeGrabTool},
    ToolMaker{ui::Tool::pin, makePinTool},
    ToolMaker{ui::Tool::retract, makeRetractTool},
    ToolMaker{ui::Tool::move, makeMoveTool},
    ToolMaker{ui::Tool::measure, makeMeasureTool},
};
static_assert(ui::coversTools(kToolMakers), "a ui::Tool has no maker, or not at its place");

}  // namespace kerf::app
