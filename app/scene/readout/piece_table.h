#pragma once

#include "sim/run/simulation.h"
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

}  // namespace kerf::app
