#pragma once

#include <array>
#include <memory>

#include "app/tools/tool.h"

namespace kerf::app {

/// The tools of the left button, one of each, and the one in hand. All stay alive: the guillotine
/// keeps its pose and the measures stand while another tool is used.
class ToolBox {
  public:
    ToolBox();

    /// Another document is open: all begin anew, but the choices of a person stay.
    void begin(const Bounds& bounds);
    /// Fits all to a body of other bounds.
    void fitTo(const Bounds& bounds);

    ui::ToolSettings& settings() { return settings_; }
    const ui::ToolSettings& settings() const { return settings_; }
    /// Takes another tool, which makes the one before let go, or other settings of this one.
    void set(const ui::ToolSettings& wanted, const ToolContext& c);

    Tool& inHand() const { return *tools_[static_cast<std::size_t>(settings_.tool)]; }
    /// Whether the tool in hand holds what takes part in the simulation.
    bool holdsBody() const { return inHand().holds() && !ui::rowOf(settings_.tool).leadsBlade; }
    /// Gives up the stroke and lets go of everything; `takesBack` what was done too.
    void cancel(const ToolContext& c, bool takesBack);
    /// Adds the way of the blade, and what the tool in hand shows.
    void addTo(ui::Overlay& overlay, const ToolContext& c) const;

    /// A tool by its class, such as MoveTool.
    template <class Kind>
    Kind& get() const {
        return static_cast<Kind&>(*tools_[static_cast<std::size_t>(Kind::kTool)]);
    }

  private:
    ui::ToolSettings settings_;
    std::array<std::unique_ptr<Tool>, ui::kTools> tools_;
};

}  // namespace kerf::app
