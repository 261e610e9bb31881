#pragma once

#include "app/scene/readout/cut_quality.h"
#include "app/scene/readout/editor_readings.h"
#include "app/scene/readout/load_table.h"
#include "app/scene/readout/surface_look.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/skin_follower.h"
#include "app/session/task_run.h"
#include "app/session/volume_watch.h"
#include "render/renderer.h"
#include "sim/run/simulation.h"
#include "ui/state/panel_model.h"
#include "ui/state/piece_row.h"

namespace kerf::app {

/// The pieces of a body for the panels: volumes from time to time, areas and centres on request.
class PieceTable {
  public:
    const std::vector<ui::PieceRow>& rows() const { return rows_; }
    /// Measures the volumes again.
    void refresh(const Simulation& simulation);
    /// Measures them again if the body was cut, or after a while. `playing`: time runs.
    void follow(const Simulation& simulation, bool playing);
    /// Also computes areas and centres.
    void addUp(Simulation& simulation);
    /// Whether these are up to date.
    bool isAddedUp(const Simulation& simulation) const {
        return sumsRevision_ == simulation.bodyRevision();
    }

  private:
    std::vector<ui::PieceRow> rows_;
    int sumsRevision_ = -1;  ///< of the body that the sums are of
    int step_ = -1;          ///< that the rows tell of
    int triangles_ = -1;
};

/// The pictures, exports, checks, strokes and changes of a log, for the timeline.
class MarkTable {
  public:
    /// Updates them if the log has changed.
    void follow(const EventLog& log);
    const std::vector<ui::SessionMark>& marks() const { return marks_; }
    const std::vector<ui::SessionMark>& past() const { return past_; }

  private:
    std::vector<ui::SessionMark> marks_, past_;
    int revision_ = -1;        ///< of the log
    std::size_t entries_ = 0;  ///< its length then
};

/// The view and the figures of a scene; it changes nothing.
class SceneReadout {
  public:
    /// Both must outlive it.
    SceneReadout(SceneBody& body, const SceneTimeline& timeline)
        : body_(body), timeline_(timeline) {}

    /// The surface under the pointer and ahead of the blade.
    SurfaceLook& look() { return look_; }

    /// Computes the thickness of the body if `wanted` and the body `rests`. Returns whether it has
    /// changed since the last view().
    bool followThickness(bool wanted, bool rests) {
        return thickness_.follow(body_.simulation, wanted, rests);
    }
    const ThicknessMap& thickness() const { return thickness_; }
    /// Measures the quality of the cuts if `wanted`, between strokes. Returns whether the panels
    /// must be updated.
    bool followCuts(bool wanted) { return cuts_.follow(body_.simulation, wanted); }
    const CutQuality& cuts() const { return cuts_; }
    /// Computes areas and centres of the pieces if `wanted`. Returns whether they have changed.
    bool followPieceSums(bool wanted);
    /// The pieces as they are now, with their sums.
    const std::vector<ui::PieceRow>& measurePieces();
    using MarksPointer = std::shared_ptr<const std::vector<render::Marks>>;
    /// The document's faults as marks on the present body, where its triangles are undivided.
    const MarksPointer& faultMarks();
    /// These where `faults`, and dots on the vertices of a load, by its row; -1 for none. The same
    /// pointer while they are the same.
    MarksPointer marks(bool faults, int load);
    /// What holds or pulls the body, as the panels show it.
    const std::vector<Load>& loads() const { return loads_.loads(); }
    /// What does so now.
    const std::vector<Load>& takeLoads();
    const EditorReadings& readings() const { return readings_; }
    /// The forces on the blade in the steps so far, where they are measured.
    const ForceTrace& forces() const { return forces_; }

    /// The scene for the renderer.
    render::SceneView view();
    /// Fills in what the panels show of it.
    void describe(ui::PanelModel& model);

    /// Drops the readings so far: the panels count from the present.
    void startAnew();
    /// Takes the values of a finished step, and reports pieces that lost their volume.
    void addStep(const StepReport& report, int piecesBefore);
    /// Takes the values of the state after a command, with its name in the plots.
    void addJump(const char* name);
    /// Follows a jump of the body to another time, which may count from another start.
    void goBack(bool countsAnew);
    /// Plots the values of a point from now on, in place of another; none: of no point.
    void plot(std::optional<SurfaceAnchor> point);
    /// Records a frame, with the drawing time since the previous one [ms].
    void addPicture(const FrameTime& frame, double renderMs);

  private:
    void addPoint();
    void describeModels(ui::PanelModel& model) const;
    void describeChanges(ui::ChangeList& list) const;

    SceneBody& body_;
    const SceneTimeline& timeline_;
    SurfaceLook look_;
    SkinFollower skin_{body_.document.looks};
    ThicknessMap thickness_;
    CutQuality cuts_;
    EditorReadings readings_;
    ForceTrace forces_;
    std::optional<SurfaceAnchor> point_;  ///< that is plotted
    VolumeWatch volumes_;
    PieceTable pieces_;
    MarkTable marks_;
    LoadTable loads_;
    MarksPointer faultMarks_;
    int marksTriangles_ = -1;  ///< of the body that those are of
    MarksPointer allMarks_;    ///< with those of a load
};

}  // namespace kerf::app
