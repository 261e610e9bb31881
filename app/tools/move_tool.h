#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene/editor_scene.h"
#include "app/tools/gizmo.h"
#include "app/tools/tool_table.h"

namespace kerf::app {

/// Moves, turns and sizes by a gizmo what stands in the scene (ui::Tool::move): a box, what is
/// pinned, or the uncut model. A click chooses which. It changes nothing itself: what a drag asks
/// for is taken from it between two steps.
class MoveTool : public Tool {
  public:
    static constexpr ui::Tool kTool = ui::Tool::move;

    /// Takes a part of the gizmo, or chooses what lies under the pointer.
    std::string press(const ToolContext& c) override;
    /// With Ctrl in whole steps.
    void move(const ToolContext& c) override;
    /// The drag is over; what it asks for is still to be taken.
    std::string release(const ToolContext& c) override;
    /// Ends the drag; what it still asks for is forgotten.
    void cancel(const ToolContext& c) override;
    void takeBack(const ToolContext& c) override;
    bool holds() const override { return gizmo_.holds(); }
    /// Chooses a box by its number.
    void chooseBox(int box) { subject_ = {Kind::box, box}; }

    /// What the drag asks for since the last time; none where it asks for nothing.
    std::optional<Command> takeCommand(const EditorScene& scene);
    /// Notes that it was done, or could not be.
    void noteOutcome(bool done, const EditorScene& scene);
    /// Adds the gizmo; whether a press would choose something else is told too.
    void addTo(ui::Overlay& overlay, const ToolContext& c) const override;
    ui::Cursor cursor(const ui::Overlay& overlay) const override;

  private:
    enum class Kind { model, pins, box };
    struct Subject {
        Kind kind = Kind::model;
        int number = 0;  ///< of the model or the box
        bool operator==(const Subject&) const = default;
    };
    /// What is held as it was when it was taken, and what was asked for so far.
    struct Start {
        Subject subject;
        GizmoFrame frame;
        StaticBox box;
        Placement placement;
        bool continues = false;
        std::size_t changes = 0;  ///< in force once the last command was done
        GizmoChange sent;
    };
    Subject subjectOf(const EditorScene& scene) const;
    static std::optional<Subject> subjectAt(const ToolContext& c);
    /// Where the gizmo is; none where there is nothing to handle.
    std::optional<GizmoFrame> frameOf(EditorScene& scene) const;
    bool isOver(const ToolContext& c, const std::optional<GizmoFrame>& frame) const;
    Command commandOf(const GizmoChange& change) const;
    Command placed(const GizmoChange& change) const;

    std::optional<Subject> subject_;  ///< that was chosen
    Gizmo gizmo_;
    std::optional<Start> start_;  ///< from the press until all that it asked for is done
    std::optional<GizmoChange> wanted_;
    /// The middle of what is pinned, which is costly to read.
    struct PinsMiddle {
        std::vector<std::uint32_t> vertices;
        int revision = -1;
        Vec3 at = Vec3::Zero();
    };
    Vec3 middleOfPins(EditorScene& scene) const;
    mutable PinsMiddle pins_;
};

}  // namespace kerf::app
