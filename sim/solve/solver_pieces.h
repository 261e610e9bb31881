#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "shaders/shared/body_records.h"
#include "sim/body/body_model.h"
#include "sim/solve/scatter.h"
#include "sim/solve/vertex_pages.h"

namespace kerf {

/// The volume that a piece is held at; chips are left alone (PieceModel::holdsVolume).
struct VolumeTarget {
    double volume = 0;  ///< [m^3]
    bool constrained = true;
};

/// The pieces of a body on the GPU, with the pages on which their vertices lie and the blocks of
/// pages over which work groups sum.
class SolverPieces {
  public:
    /// Takes the pages on which the vertices of a new body lie; upload() follows.
    void setPages(VertexPages pages);
    /// Moves vertices to the pages of other pieces after a cut; upload() follows.
    void updatePages(std::span<const LabelMove> moves, const BodyModel& model);
    const VertexPages& pages() const { return pages_; }

    /// Uploads the records of all pieces: few, however large the body, since pages hold hundreds of
    /// vertices. Volume targets are the rest volumes. Throws gpu::OutOfMemory.
    void upload(const BodyModel& model, Scatter& scatter);
    /// Sets the volume targets, one per piece.
    void setVolumeTargets(std::span<const VolumeTarget> targets);

    const std::vector<shared::PieceRecord>& pieces() const { return pieces_; }
    const std::vector<shared::BlockRecord>& blocks() const { return blocks_; }

    gpu::Buffer pieceBuffer, blockBuffer, pageBuffer, placeBuffer;
    gpu::Buffer blockSums, impulses;  ///< room for what is summed
    gpu::Buffer blockMeasures;        ///< the same; the CPU learns them after each step

  private:
    void addRecord(const PieceModel& piece, std::size_t number, std::vector<std::uint32_t>& table);
    void makeRoomForSums();

    VertexPages pages_;
    std::vector<shared::PieceRecord> pieces_;
    std::vector<shared::BlockRecord> blocks_;
};

}  // namespace kerf
