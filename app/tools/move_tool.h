#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene/editor_scene.h"
#include "app/tools/gizmo.h"

namespace kerf::app {

/// Moves, turns and sizes by a gizmo what stands in the scene (Tool::move): a box, what is pinned,
/// or the uncut model. A click chooses which.
class MoveTool {
  public:
    /// Takes a part of the gizmo, or chooses what lies at a pixel. Returns "" or one sentence.
    std::string press(const ViewFrame& view, const Vec2& pixel, EditorScene& scene);
    /// `snaps`: in whole steps.
    void move(const ViewFrame& view, const Vec2& pixel, bool snaps);
    /// The drag is over; what it asks for is still to be taken.
    void release();
    /// Ends the drag; what it still asks for is forgotten.
    void drop();
    bool holds() const { return gizmo_.holds(); }
    /// Forgets what was chosen: another document was opened.
    void forget() { *this = MoveTool{}; }
    /// Chooses a box by its number.
    void chooseBox(int box) { subject_ = {Kind::box, box}; }

    /// What the drag asks for since the last time; none where it asks for nothing.
    std::optional<Command> takeCommand(const EditorScene& scene);
    /// Notes that it was done, or could not be.
    void noteOutcome(bool done, const EditorScene& scene);
    /// Ends the drag and takes back what it did.
    void undoDrag(EditorScene& scene);

    /// Whether the gizmo, or something that a click would choose, is at a pixel.
    bool isOver(const ViewFrame& view, const Vec2& pixel, EditorScene& scene) const;
    void addTo(ui::Overlay& overlay, const ViewFrame& view, const Vec2& pixel,
               EditorScene& scene) const;
    /// Where the gizmo is; none where there is nothing to handle.
    std::optional<GizmoFrame> frameOf(EditorScene& scene) const;

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
    static std::optional<Subject> subjectAt(const ViewFrame& view, const Vec2& pixel,
                                            EditorScene& scene);
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
