#pragma once

#include <array>
#include <memory>

#include "app/tools/tool.h"

namespace kerf::app {

// What makes each tool, in the file of its name.
std::unique_ptr<Tool> makeStrokeTool();
std::unique_ptr<Tool> makeScalpelTool();
std::unique_ptr<Tool> makeGuillotineTool();
std::unique_ptr<Tool> makeGrabTool();
std::unique_ptr<Tool> makePinTool();
std::unique_ptr<Tool> makeRetractTool();
std::unique_ptr<Tool> makeMoveTool();
std::unique_ptr<Tool> makeMeasureTool();

/// The half of a row of ui::kToolRows that the panels don't know.
struct ToolMaker {
    ui::Tool tool;
    std::unique_ptr<Tool> (*make)();
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
