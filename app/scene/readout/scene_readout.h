#pragma once

#include <memory>
#include <vector>

#include "app/scene/readout/cut_quality.h"
#include "app/scene/readout/editor_readings.h"
#include "app/scene/readout/piece_table.h"
#include "app/scene/readout/surface_look.h"
#include "app/scene/readout/thickness_map.h"
#include "app/scene/timeline/scene_timeline.h"
#include "app/session/skin_follower.h"
#include "app/session/volume_watch.h"
#include "render/renderer.h"
#include "sim/solve/sweep_strength.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The pictures, exports, checks, strokes and changes of a journal, as the time line shows them.
class MarkTable {
  public:
    /// Lists them anew where the journal has changed.
    void follow(const SessionJournal& journal);
    const std::vector<ui::SessionMark>& marks() const { return marks_; }
    const std::vector<ui::SessionMark>& course() const { return course_; }

  private:
    std::vector<ui::SessionMark> marks_, course_;
    int revision_ = -1;        ///< of the journal
    std::size_t entries_ = 0;  ///< its length then
};

/// What is seen of a scene and told of it: it changes nothing.
class SceneReadout {
  public:
    /// Both must outlive it.
    SceneReadout(SceneBody& body, const SceneTimeline& timeline)
        : body_(body), timeline_(timeline) {}

    /// What is under the pointer and before the blade.
    SurfaceLook& look() { return look_; }

    /// Lets the thickness of the body be worked out where it is `wanted` and the body `rests`. True
    /// where it is another than in the last view().
    bool followThickness(bool wanted, bool rests) {
        return thickness_.follow(body_.simulation, wanted, rests);
    }
    const ThicknessMap& thickness() const { return thickness_; }
    /// Lets the quality of the cuts be measured where it is `wanted`, between strokes. True where
    /// the panels have something else to show.
    bool followCuts(bool wanted) { return cuts_.follow(body_.simulation, wanted); }
    const CutQuality& cuts() const { return cuts_; }
    /// Adds up areas and middles of the pieces where they are `wanted`. True where they are other
    /// ones than before.
    bool followPieceSums(bool wanted);
    /// The pieces as they are now, with their sums.
    const std::vector<ui::PieceRow>& measurePieces();
    /// The document's faults as marks on the body as it is, as far as the triangles are whole.
    const std::shared_ptr<const std::vector<render::Marks>>& faultMarks();
    const EditorReadings& readings() const { return readings_; }

    /// The scene for the renderer.
    render::SceneView view();
    /// Fills in what the panels show of it.
    void describe(ui::PanelModel& model);

    /// Forgets what was read so far: the panels count from the present.
    void startAnew();
    /// Takes the values of a step that has ended, and tells where a piece lost its volume.
    void addStep(const StepReport& report, int piecesBefore);
    /// Takes the values of the state that a command jumped to, with its name in the plots.
    void addJump(const char* name);
    /// Goes back with the body to the present, which may count from another start.
    void goBack(bool countsAnew);
    /// Notes a picture while time runs: how long after the one before it came [s], and how long it
    /// took to draw [ms].
    void addPicture(double elapsedSeconds, double renderMs);

  private:
    void describeModels(ui::PanelModel& model) const;
    void describeChanges(ui::ChangeList& list) const;

    SceneBody& body_;
    const SceneTimeline& timeline_;
    SweepStrength sweeps_;
    SurfaceLook look_;
    SkinFollower skin_{body_.document.looks};
    ThicknessMap thickness_;
    CutQuality cuts_;
    EditorReadings readings_;
    VolumeWatch volumes_;
    PieceTable pieces_;
    MarkTable marks_;
    std::shared_ptr<const std::vector<render::Marks>> faultMarks_;
    int marksTriangles_ = -1;  ///< of the body that those are of
};

}  // namespace kerf::app
