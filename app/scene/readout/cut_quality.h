#pragma once

#include "app/files/jobs/background_job.h"
#include "app/session/cut_report.h"
#include "sim/run/simulation.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The quality of the cuts of a body for panels. It is measured on a separate thread between
/// strokes, and kept until the next result.
class CutQuality {
  public:
    /// If `wanted`: takes a finished result, and begins to measure the present body, unless that is
    /// known or a stroke is in progress. Returns whether rows() or note() have changed.
    bool follow(Simulation& simulation, bool wanted);
    /// Figures of all cuts and of the last stroke; empty if none is known.
    const std::vector<ui::CutRow>& rows() const { return rows_; }
    /// A note on outdated or missing rows; empty if they are up to date.
    const std::string& note() const { return note_; }
    bool working() const { return job_ != nullptr; }

  private:
    using Report = std::optional<CutReport>;

    void begin(Simulation& simulation);
    void takeReady();
    std::string noteOf(const Simulation& simulation) const;

    int known_ = -1;    ///< revision of the body's model in the rows
    int working_ = -1;  ///< of what job_ measures
    std::vector<ui::CutRow> rows_;
    std::string note_;
    std::unique_ptr<BackgroundJob<Report>> job_;
};

/// The rows of the table of the panel.
std::vector<ui::CutRow> rowsOf(const CutReport& report);

}  // namespace kerf::app
