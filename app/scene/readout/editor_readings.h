#pragma once

#include "app/scene/readout/surface_anchor.h"
#include "sim/run/simulation.h"
#include "ui/plots/history.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// What is plotted of a point of the surface.
struct PointValues {
    double strain = 0;  ///< the larger principal strain, as in render::SurfaceField
    double area = 0;    ///< change of area, as there
    double way = 0;     ///< from its place at rest [m]
    double speed = 0;   ///< [m/s]
};

/// The values at a point now; reads the triangles around it back if stale.
PointValues valuesAt(const SurfaceMesh& mesh, const SurfaceAnchor& anchor);

/// Detects pieces that hit the floor.
class ImpactWatch {
  public:
    /// Whether a piece hits the floor in this step. `boxes`: around the pieces, `size`: of the body
    /// [m].
    bool see(const std::vector<Bounds>& boxes, std::optional<double> floor, double size);

  private:
    std::vector<bool> clear_;  ///< of the floor, by piece
};

/// The time from one picture of a running scene to the next [s]; 0 where time stood still between
/// them.
struct FrameTime {
    double all = 0;
    double steps = 0;  ///< of it, in steps
};

/// The data of the plots and the stage table of a run since its start, by its time [s].
class EditorReadings {
  public:
    void clear() { *this = EditorReadings{}; }
    /// Takes the values of a step that ended at `time`.
    void addStep(double time, const Simulation& simulation);
    /// Takes the values of the state after undo or redo.
    void addJump(double time, const Simulation& simulation);
    /// Takes the times of a frame that shows `time`.
    void addPicture(double time, const FrameTime& frame, double renderMs);
    /// Takes the values of the plotted point.
    void addPoint(double time, const PointValues& values);
    void forgetPoint();
    void mark(double time, std::string label) {
        history_.marks.push_back({time, std::move(label)});
    }
    void forgetAfter(double time);

    const ui::History& history() const { return history_; }
    /// The real-time factor of about the last second in which time ran; none before that.
    std::optional<double> realTimeFactor() const { return realTimeFactor_; }
    /// Mean frame rate and volume; none before the first step and the first frame.
    std::optional<ui::RunFigures> figures() const;

  private:
    /// `stepped`: a step has just ended, no jump.
    void addReport(double time, const Simulation& simulation, bool stepped);
    void addPieces(double time, const std::vector<Piece>& pieces);

    ui::History history_;
    ImpactWatch impacts_;
    double stagesMs_ = 0;                   ///< of the steps since the last frame
    std::optional<double> pictured_;        ///< the time that frame showed; none after a jump
    std::optional<double> realTimeFactor_;  ///< smoothed
};

}  // namespace kerf::app
