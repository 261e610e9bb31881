#include "app/scene/readout/piece_table.h"

#include "sim/mesh/invariants.h"
#include "sim/mesh/piece_figures.h"

namespace kerf::app {
namespace {

constexpr int kRefreshEvery = 10;  // steps

}  // namespace

void PieceTable::refresh(const Simulation& simulation) {
    const bool same = isAddedUp(simulation);
    const std::vector<ui::PieceRow> before = std::exchange(rows_, {});
    const std::vector<Bounds>& bounds = simulation.pieceBounds();
    double all = 0;
    for (const Piece& piece : simulation.measuredPieces()) {
        ui::PieceRow row;
        row.triangles = piece.triangles;
        row.volume = piece.volume;
        row.share = piece.restVolume > 0 ? piece.volume / piece.restVolume : 0;
        const std::size_t p = rows_.size();
        row.bounds = p < bounds.size() ? bounds[p] : Bounds{};
        row.sums = same && p < before.size() ? before[p].sums : std::nullopt;
        all += piece.volume;
        rows_.push_back(row);
    }
    for (ui::PieceRow& row : rows_) {
        row.shareOfAll = all > 0 ? row.volume / all : 0;
    }
    step_ = simulation.stepCount();
    triangles_ = simulation.report().triangles;
}

void PieceTable::follow(const Simulation& simulation, bool playing) {
    const int age = simulation.stepCount() - step_;
    const bool recut = simulation.report().triangles != triangles_;
    if (recut || age >= kRefreshEvery || (age != 0 && !playing)) {
        refresh(simulation);
    }
}

void PieceTable::addUp(Simulation& simulation) {
    refresh(simulation);
    const std::vector<int> triangles = simulation.trianglesOfPieces();
    const SurfaceMesh& mesh = simulation.mesh();
    const PieceShells shells(mesh);
    for (std::size_t p = 0; p < rows_.size(); ++p) {
        if (triangles[p] >= 0) {
            const PieceFigures figures = figuresOfPiece(mesh, shells, triangles[p]);
            rows_[p].sums = {figures.skinArea, figures.cutArea, figures.centroid};
        }
    }
    sumsRevision_ = simulation.bodyRevision();
}

}  // namespace kerf::app
