#include "app/cli/replay/run_files.h"

#include "app/session/session.h"

namespace kerf::app {

namespace {

void begin(std::optional<AtomicFile>& table, OutputFolder& folder, const char* name,
           const std::string& header) {
    table.emplace(folder.pathOf(name));
    table->write(header);
}

}  // namespace

RunFiles::RunFiles(OutputFolder& folder, bool hashes, bool pieces)
    : folder_(folder), metrics_(folder.pathOf(kMetricsFile)) {
    metrics_.write(metricsHeader());
    if (hashes) {
        begin(hashes_, folder, kHashesFile, hashesHeader());
    }
    if (pieces) {
        begin(pieces_, folder, kPiecesFile, piecesHeader());
    }
}

void RunFiles::commit() {
    metrics_.commit();
    folder_.noteWritten(kMetricsFile);
    if (hashes_) {
        hashes_->commit();
        folder_.noteWritten(kHashesFile);
    }
    if (pieces_) {
        pieces_->commit();
        folder_.noteWritten(kPiecesFile);
    }
}

}  // namespace kerf::app
