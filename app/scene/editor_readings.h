#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/run/simulation.h"
#include "ui/history.h"
#include "ui/panel_model.h"

namespace kerf::app {

/// Tells when a piece meets the floor after it was clear of it.
class ImpactWatch {
  public:
    /// True in the step in which a piece comes down. `boxes`: around the pieces, `size`: of the
    /// body [m].
    bool see(const std::vector<Bounds>& boxes, std::optional<double> floor, double size);

  private:
    std::vector<bool> clear_;  ///< of the floor, by piece
};

/// The readings that plots and stage table show of a run since its start, by its time [s].
class EditorReadings {
  public:
    void clear() { *this = EditorReadings{}; }
    /// After a step that ended at `time`.
    void addStep(double time, const Simulation& simulation);
    /// After a step without one: what undo and redo jump to.
    void addJump(double time, const Simulation& simulation);
    /// After a picture that came so long after the one before [s], and was drawn in so long [ms].
    void addPicture(double time, double elapsedSeconds, double renderMs);
    void mark(double time, std::string label) {
        history_.marks.push_back({time, std::move(label)});
    }
    void forgetAfter(double time);

    const ui::History& history() const { return history_; }
    /// Mean frame rate and volume; none before the first step and the first picture.
    std::optional<ui::RunFigures> figures() const;

  private:
    void addState(double time, const Simulation& simulation);
    ui::Series& stage(ui::Stage stage) { return history_.stages[static_cast<std::size_t>(stage)]; }

    ui::History history_;
    ImpactWatch impacts_;
};

}  // namespace kerf::app
