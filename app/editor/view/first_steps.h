#pragma once

#include "app/editor/view/editor_view.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The outcome of a stroke.
enum class StrokeOutcome : std::uint8_t {
    none,     ///< no stroke, or the body has changed otherwise since
    missed,   ///< the blade met nothing
    incised,  ///< it cut without making pieces
    parted,   ///< there are more pieces
};

/// Finds the outcome of the last stroke by comparing the body before and after.
class CutWatch {
  public:
    /// Records the state of the body once a frame, before its steps. `cutting`: whether a stroke is
    /// drawn or still to be cut.
    void follow(bool cutting, int pieces, int triangles);
    StrokeOutcome outcome() const { return outcome_; }

  private:
    struct MeshCounts {
        int pieces = 0;
        int triangles = 0;
        bool operator==(const MeshCounts&) const = default;
    };
    StrokeOutcome outcomeOf(const MeshCounts& now) const;

    std::optional<MeshCounts> before_;  ///< of the stroke in progress
    bool met_ = false;                  ///< it changed the body
    MeshCounts after_;                  ///< of the last one
    StrokeOutcome outcome_ = StrokeOutcome::none;
};

/// The situation in the editor that selects a hint.
struct Situation {
    bool open = false;        ///< whether anything is
    bool playing = false;     ///< time runs
    bool weightless = false;  ///< there is no gravity
    bool session = false;     ///< events of a session are still to come
    bool past = false;        ///< the person went back in time
    bool cutting = false;     ///< a stroke is drawn or still to be cut
    bool touching = false;    ///< a tool pulls or pins
    bool task = false;        ///< one is practised
    bool cut = false;         ///< a stroke was cut since the body was whole
    bool scored = false;      ///< the try was
    bool hasExpert = true;    ///< the task
    bool makesTask = false;   ///< see Document::makesTask
    ui::ToolKind tool = ui::kFirstTool;
    int pieces = 1;
    int piecesAtFirst = 1;  ///< when opened: a file may hold several shells
    StrokeOutcome outcome = StrokeOutcome::none;
    std::string refusal{};  ///< message about a refused step of the last stroke

    bool parted() const { return pieces > piecesAtFirst; }
};

/// Guides a new user from the first cut to the next actions. Each hint disappears for good once its
/// action was done.
class FirstSteps {
  public:
    /// Records the situation once a frame.
    void follow(const Situation& now);
    /// The hint for a situation; empty for none.
    ui::Hint hint(const Situation& now) const;

  private:
    bool hasUsed(ui::ToolKind tool) const { return used_[static_cast<std::size_t>(tool)]; }
    ui::Hint afterStroke(const Situation& now) const;
    ui::Hint beforeStroke(const Situation& now) const;

    std::array<bool, ui::kTools> used_{};
    ui::ToolKind cutTool_ = ui::kFirstTool;  ///< of the last stroke
    bool played_ = false;                    ///< a session
    bool parted_ = false;                    ///< something was cut right through
    bool weighed_ = false;                   ///< time ran with gravity
    bool fell_ = false;                      ///< and did so with pieces
    bool wentOn_ = false;                    ///< a stroke was drawn after that
};

/// Follows what a new user does, and suggests what to do next.
class NewcomerGuide {
  public:
    /// Follows the open document once a frame. Returns whether the outcome of the last stroke has
    /// changed.
    bool follow(const EditorScene& scene, const EditorView& view);
    /// Drops the last stroke: this document was just opened.
    void begin(const EditorScene& scene);
    /// Suggests what to try in this document, until something was tried. "" suggests nothing.
    void suggest(std::string tip) { tip_ = std::move(tip); }
    /// The present hint; `scene` is null if nothing is open.
    /// `scored`: the try at its task was.
    ui::Hint hint(const EditorScene* scene, const EditorView& view, bool scored) const;

  private:
    Situation situationOf(const EditorScene* scene, const EditorView& view) const;
    std::string whyItTears(const EditorScene& scene, const EditorView& view) const;

    CutWatch cutWatch_;
    FirstSteps firstSteps_;
    int piecesAtFirst_ = 1;
    double toreAt_ = -1;  ///< simulated time [s]
    std::string tip_;
};

}  // namespace kerf::app
