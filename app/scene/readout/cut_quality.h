#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/jobs/background_job.h"
#include "app/session/cut_report.h"
#include "sim/run/simulation.h"
#include "ui/state/cut_rows.h"

namespace kerf::app {

/// The quality of the cuts of a body, as panels show it. It is measured on a thread of its own
/// between strokes, and kept until a newer one is there.
class CutQuality {
  public:
    /// Where it is `wanted`: takes what is ready, and begins with the body as it is, unless that is
    /// known or a stroke goes on. True where rows() or note() are others than before.
    bool follow(Simulation& simulation, bool wanted);
    /// Figures of all cuts and of the last stroke; empty where none is known.
    const std::vector<ui::CutRow>& rows() const { return rows_; }
    /// What is to be said of the rows, or why there are none; empty where they are those of now.
    const std::string& note() const { return note_; }
    bool working() const { return job_ != nullptr; }

  private:
    using Report = std::optional<CutReport>;

    void begin(Simulation& simulation);
    void takeReady();
    std::string noteOf(const Simulation& simulation) const;

    int known_ = -1;    ///< revision of the body's model that the rows are of
    int working_ = -1;  ///< of what job_ measures
    std::vector<ui::CutRow> rows_;
    std::string note_;
    std::unique_ptr<BackgroundJob<Report>> job_;
};

/// The rows of the table of the panel.
std::vector<ui::CutRow> rowsOf(const CutReport& report);

}  // namespace kerf::app
