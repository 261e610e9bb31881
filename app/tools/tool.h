#pragma once

#include "app/tools/view_frame.h"
#include "render/scene/overlays.h"
#include "sim/cut/blade.h"
#include "ui/base/input.h"
#include "ui/state/tool_settings.h"

namespace kerf::app {

class BladeStroke;
class EditorScene;

/// Said where a tool that takes a point of the body was pressed beside it.
inline constexpr std::string_view kBesideModel = "Nothing is there. Press on the model.";

/// The context of each call to a tool.
struct ToolContext {
    ViewFrame view;
    Vec2 pixel = Vec2::Zero();  ///< pointer, in the frame
    ui::Modifiers modifiers;
    ui::ToolSettings& settings;  ///< of all tools; each changes only its own
    BladeStroke& stroke;         ///< that takes the poses of a blade
    const Bounds& bounds;        ///< of the body [m]
    const std::optional<render::SectionPlane>& section;  ///< of the view
    /// The open scene between two steps; may be null for a tool that reads no body (ui::ToolRow).
    EditorScene* scene;
    bool showsAhead = false;  ///< what a stroke under way will cut
};

/// A tool of the left button in the view (ui::ToolKind). It follows the pointer, moves the blade or
/// changes the body, and shows an overlay of its effect. Returned sentences are "" on success.
class Tool {
  public:
    virtual ~Tool() = default;

    /// Fits its settings to another body or placement, and drops what it holds of the previous one.
    virtual void fitTo(const Bounds& /*bounds*/, ui::ToolSettings& /*settings*/) {}

    /// The left button was pressed. Returns "" or one sentence.
    virtual std::string press(const ToolContext& /*c*/) { return ""; }
    virtual void move(const ToolContext& /*c*/) {}
    /// The left button was released. Returns "" or one sentence.
    virtual std::string release(const ToolContext& /*c*/) { return ""; }
    /// Releases what it holds, and cancels the drag as far as possible.
    virtual void cancel(const ToolContext& /*c*/) {}
    /// Esc: the same, and reverts the effect of the drag on the body.
    virtual void takeBack(const ToolContext& c) { cancel(c); }
    /// Another tool is selected: releases.
    virtual void putAway(const ToolContext& c) { cancel(c); }
    /// Whether the blade, the body or a handle is held.
    virtual bool holds() const { return false; }
    /// Whether a press aims at a place of the displayed body.
    virtual bool aims() const { return true; }

    /// The panel changed its settings from those of `before`.
    virtual void followSettings(const ui::ToolSettings& /*before*/, const ToolContext& /*c*/) {}
    /// Does the action of ui::ToolRow::trigger.
    virtual void trigger(const ToolContext& /*c*/) {}
    /// Whether it handles right clicks, by rightClick().
    virtual bool takesRightClicks() const { return false; }
    virtual void rightClick(const ToolContext& /*c*/) {}
    /// Esc while it holds nothing. Returns whether the tool used it.
    virtual bool escape(ui::ToolSettings& /*settings*/) { return false; }

    /// The wheel was turned over the view. Returns whether the tool used it.
    virtual bool turnWheel(double /*notches*/, const ToolContext& /*c*/) { return false; }
    /// A figure beside the pointer, such as a depth; "" for none.
    virtual std::string figure(const ui::ToolSettings& /*settings*/) const { return ""; }

    /// The poses that the blade would take from here, while no stroke is in progress.
    virtual std::vector<Blade> wayAhead(const ToolContext& /*c*/) const { return {}; }
    /// Adds its overlay. The path of the blade is there already.
    virtual void addTo(ui::Overlay& /*overlay*/, const ToolContext& /*c*/) const {}
    /// The shape of the pointer over the view, with `overlay` and nothing held.
    virtual ui::Cursor cursor(const ui::Overlay& /*overlay*/) const {
        return ui::Cursor::crosshair;
    }
};

// What makes each tool, in the file of its name.
using MakeTool = std::unique_ptr<Tool>();
MakeTool makeStrokeTool, makeScalpelTool, makeGuillotineTool, makeGrabTool, makePinTool,
    makeRetractTool, makeMoveTool, makeMeasureTool;

/// The part of a row of ui::kToolRows unknown to the panels.
struct ToolMaker {
    ui::ToolKind tool;
    MakeTool* make;
};
inline constexpr std::array kToolMakers{
    ToolMaker{ui::ToolKind::stroke, makeStrokeTool},
    ToolMaker{ui::ToolKind::scalpel, makeScalpelTool},
    ToolMaker{ui::ToolKind::guillotine, makeGuillotineTool},
    ToolMaker{ui::ToolKind::grab, makeGrabTool},
    ToolMaker{ui::ToolKind::pin, makePinTool},
    ToolMaker{ui::ToolKind::retract, makeRetractTool},
    ToolMaker{ui::ToolKind::move, makeMoveTool},
    ToolMaker{ui::ToolKind::measure, makeMeasureTool},
};
static_assert(ui::coversTools(kToolMakers), "a tool has no maker, or not at its place");

}  // namespace kerf::app
