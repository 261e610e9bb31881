#pragma once

#include <optional>
#include <string>

#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/session/hash_course.h"
#include "app/session/metrics.h"

namespace kerf::app {

/// The tables that a replay writes as it goes: metrics.csv, and where they are wanted hashes.csv
/// and pieces.csv. They appear under their names once they are complete.
class RunFiles {
  public:
    /// Begins the tables. Throws OutputError, as all functions here.
    RunFiles(OutputFolder& folder, bool hashes, bool pieces);

    bool wantsHashes() const { return hashes_.has_value(); }
    bool wantsPieces() const { return pieces_.has_value(); }
    void write(const MetricsRow& row) { metrics_.write(formatMetrics(row)); }
    void write(int step, const StateHashes& hashes) { hashes_->write(formatHashes(step, hashes)); }
    void write(int step, const std::vector<Piece>& pieces, const std::vector<Bounds>& boxes,
               const Vec3& from) {
        pieces_->write(formatPieces(step, pieces, boxes, from));
    }
    /// Lets them appear.
    void commit();

  private:
    OutputFolder& folder_;
    AtomicFile metrics_;
    std::optional<AtomicFile> hashes_;
    std::optional<AtomicFile> pieces_;
};

}  // namespace kerf::app
