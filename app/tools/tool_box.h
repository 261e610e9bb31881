#pragma once

#include "app/tools/tool.h"

namespace kerf::app {

/// The tools of the left button, one of each, and the selected one. All stay alive: the guillotine
/// keeps its pose, and measurements stay, while another tool is used.
class ToolBox {
  public:
    ToolBox();

    /// Another document is open: resets all tools, but keeps the user's settings.
    void begin(const Bounds& bounds);
    /// Fits all to a body of other bounds.
    void fitTo(const Bounds& bounds);

    ui::ToolSettings& settings() { return settings_; }
    const ui::ToolSettings& settings() const { return settings_; }
    /// Selects another tool, releasing the previous one, or changes settings.
    void set(const ui::ToolSettings& wanted, const ToolContext& c);

    Tool& inHand() const { return *tools_[static_cast<std::size_t>(settings_.tool)]; }
    /// Whether the selected tool holds part of the simulation.
    bool holdsBody() const { return inHand().holds() && !ui::rowOf(settings_.tool).leadsBlade; }
    /// Cancels the stroke and releases everything; `takesBack` also reverts it.
    void cancel(const ToolContext& c, bool takesBack);
    /// Adds the path of the blade, and the selected tool's overlay.
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
