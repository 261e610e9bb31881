#pragma once

#include "app/scene/editor_scene.h"
#include "app/tools/gizmo.h"
#include "app/tools/tool.h"

namespace kerf::app {

/// Moves, turns and resizes by a gizmo (ui::ToolKind::move): a box, pinned vertices, or the uncut
/// model, selected by a click. It changes nothing itself: the commands of a drag are taken from it
/// between two steps.
class MoveTool : public Tool {
  public:
    static constexpr ui::ToolKind kTool = ui::ToolKind::move;

    /// Grabs a part of the gizmo, or selects what is under the pointer.
    std::string press(const ToolContext& c) override;
    /// With Ctrl in whole steps.
    void move(const ToolContext& c) override;
    /// Ends the drag; its last command is still to be taken.
    std::string release(const ToolContext& c) override;
    /// Ends the drag; drops its last command.
    void cancel(const ToolContext& c) override;
    void takeBack(const ToolContext& c) override;
    bool holds() const override { return gizmo_.holds(); }
    /// Selects a box by its number.
    void chooseBox(int box) { subject_ = {Kind::box, box}; }

    /// The command of the drag since the last call; none for no change.
    std::optional<Command> takeCommand(const EditorScene& scene);
    /// Records whether it was done.
    void noteOutcome(bool done, const EditorScene& scene);
    /// Adds the gizmo, and whether a press would select something else.
    void addTo(ui::Overlay& overlay, const ToolContext& c) const override;
    ui::Cursor cursor(const ui::Overlay& overlay) const override;

  private:
    enum class Kind { model, pins, box };
    struct Subject {
        Kind kind = Kind::model;
        int number = 0;  ///< of the model or the box
        bool operator==(const Subject&) const = default;
    };
    /// The subject at the press, and the commands so far.
    struct Start {
        Subject subject;
        GizmoFrame frame;
        StaticBox box;
        Placement placement;
        bool continues = false;
        std::size_t changes = 0;  ///< applied after the last command
        GizmoChange sent;
    };
    Subject subjectOf(const EditorScene& scene) const;
    static std::optional<Subject> subjectAt(const ToolContext& c);
    /// The frame of the gizmo; none without a subject.
    std::optional<GizmoFrame> frameOf(EditorScene& scene) const;
    bool isOver(const ToolContext& c, const std::optional<GizmoFrame>& frame) const;
    Command commandOf(const GizmoChange& change) const;
    Command placed(const GizmoChange& change) const;

    std::optional<Subject> subject_;  ///< that was chosen
    Gizmo gizmo_;
    std::optional<Start> start_;  ///< from the press until all its commands are done
    std::optional<GizmoChange> wanted_;
    /// The middle of the pinned vertices, which is costly to read.
    struct PinsMiddle {
        std::vector<std::uint32_t> vertices;
        int revision = -1;
        Vec3 at = Vec3::Zero();
    };
    Vec3 middleOfPins(EditorScene& scene) const;
    mutable PinsMiddle pins_;
};

}  // namespace kerf::app
