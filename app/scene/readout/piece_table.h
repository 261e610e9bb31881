#pragma once

#include <vector>

#include "sim/run/simulation.h"
#include "ui/state/piece_row.h"

namespace kerf::app {

/// The pieces of a body as the panels list them: volumes now and then, areas and middles where they
/// are asked for.
class PieceTable {
  public:
    const std::vector<ui::PieceRow>& rows() const { return rows_; }
    /// Measures the volumes anew.
    void refresh(const Simulation& simulation);
    /// Measures them anew where the body was cut since, or time has passed. `playing`: time runs.
    void follow(const Simulation& simulation, bool playing);
    /// Adds up areas and middles, too.
    void addUp(Simulation& simulation);
    /// Whether these are those of the body as it is.
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
