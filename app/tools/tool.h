#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/tools/view_frame.h"
#include "render/scene/section_plane.h"
#include "sim/cut/blade.h"
#include "ui/base/cursor.h"
#include "ui/base/input.h"
#include "ui/state/tool_settings.h"

namespace kerf::app {

class BladeStroke;
class EditorScene;

/// What a tool goes by at each of its verbs.
struct ToolContext {
    ViewFrame view;
    Vec2 pixel = Vec2::Zero();  ///< where the pointer is, in the picture
    ui::Modifiers modifiers;
    ui::ToolSettings& settings;  ///< of all tools; each changes its own alone
    BladeStroke& stroke;         ///< that takes the poses of a blade
    const Bounds& bounds;        ///< of the body [m]
    const std::optional<render::SectionPlane>& section;  ///< that opens the body in the view
    /// The open scene between two steps; may be null for a tool that reads no body (ui::ToolRow).
    EditorScene* scene;
};

/// A tool of the left button in the view (ui::Tool). It is told of the pointer, leads the blade or
/// changes the body, and shows over the body what it would do. Sentences are "" where all is well.
class Tool {
  public:
    virtual ~Tool() = default;

    /// Fits its settings to another body, or to one that was placed otherwise, and forgets what it
    /// holds of the one before.
    virtual void fitTo(const Bounds& /*bounds*/, ui::ToolSettings& /*settings*/) {}

    /// The left button went down. Returns "" or one sentence.
    virtual std::string press(const ToolContext& /*c*/) { return ""; }
    virtual void move(const ToolContext& /*c*/) {}
    /// The left button went up. Returns "" or one sentence.
    virtual std::string release(const ToolContext& /*c*/) { return ""; }
    /// Lets go of what it holds, as if it had not been taken as far as that goes.
    virtual void cancel(const ToolContext& /*c*/) {}
    /// Esc: the same, and takes back what the drag has done to the body.
    virtual void takeBack(const ToolContext& c) { cancel(c); }
    /// Another tool is taken: lets go.
    virtual void putAway(const ToolContext& c) { cancel(c); }
    /// Whether the blade, the body or a handle is held.
    virtual bool holds() const { return false; }
    /// Whether a press aims at a place of the body as it is shown.
    virtual bool aims() const { return true; }

    /// Its settings were changed from those of `before` by the panel.
    virtual void followSettings(const ui::ToolSettings& /*before*/, const ToolContext& /*c*/) {}
    /// Does what ui::ToolRow::trigger says.
    virtual void trigger(const ToolContext& /*c*/) {}
    /// Whether it waits for a click of the right button, which rightClick() is told of.
    virtual bool takesRightClicks() const { return false; }
    virtual void rightClick(const ToolContext& /*c*/) {}
    /// Esc while it holds nothing. Whether it meant the tool.
    virtual bool escape(ui::ToolSettings& /*settings*/) { return false; }

    /// The poses that the blade would take from here, while no stroke is under way.
    virtual std::vector<Blade> wayAhead(const ToolContext& /*c*/) const { return {}; }
    /// Adds what it shows over the body. The way of the blade is there already.
    virtual void addTo(ui::Overlay& /*overlay*/, const ToolContext& /*c*/) const {}
    /// The shape of the pointer over the view, where `overlay` is shown and nothing is held.
    virtual ui::Cursor cursor(const ui::Overlay& /*overlay*/) const {
        return ui::Cursor::crosshair;
    }
};

}  // namespace kerf::app
