#pragma once

#include "gpu/buffer.h"
#include "shaders/shared/body_records.h"
#include "sim/body/body_model.h"
#include "sim/mesh/piece_labels.h"
#include "sim/solve/scatter.h"

namespace kerf {

/// The vertices of each piece on pages of shared::kPageSize places, so that a work group can sum
/// over a page, and adding or removing a vertex changes one place. Pages may have holes.
class VertexPages {
  public:
    /// Gives every piece its own pages, its vertices ascending.
    void assign(std::span<const int> pieceOfVertex, std::size_t pieceCount);
    /// Moves vertices to other pieces. Repacks a piece that becomes half empty.
    void update(std::span<const LabelMove> moves, std::size_t vertexCount, std::size_t pieceCount);

    /// The vertex at each place, page after page; shared::kNoVertex for a hole.
    const std::vector<std::uint32_t>& places() const { return places_; }
    const std::vector<std::uint32_t>& pagesOf(std::size_t piece) const {
        return pieces_[piece].pages;
    }
    /// A vertex of the piece; shared::kNoVertex if it has none.
    std::uint32_t anyVertexOf(std::size_t piece) const;
    /// Places that changed since the last call, ascending.
    std::vector<std::uint32_t> takeChangedPlaces();

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(places_, placeOf_, pieces_, freePages_, changed_);
    }

  private:
    struct Piece {
        std::vector<std::uint32_t> pages;
        std::vector<std::uint32_t> holes;  ///< the last one is filled first
        std::size_t vertices = 0;

        template <class Archive>
        void archive(Archive& io) {
            io(pages, holes, vertices);
        }
    };

    void put(std::uint32_t vertex, Piece& piece);
    void take(std::uint32_t vertex, Piece& piece);
    void addPage(Piece& piece);
    void pack(Piece& piece);
    void set(std::uint32_t place, std::uint32_t vertex);

    std::vector<std::uint32_t> places_;
    std::vector<std::uint32_t> placeOf_;  ///< by vertex
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> freePages_;
    std::vector<std::uint32_t> changed_;
};

/// The target volume of a piece; debris has none (PieceModel::holdsVolume).
struct VolumeTarget {
    double volume = 0;  ///< [m^3]
    bool constrained = true;
};

/// The pieces of a body on the GPU, with the pages of their vertices and the blocks of pages over
/// which work groups sum.
class SolverPieces {
  public:
    /// Takes the pages of a new body; call upload() next.
    void setPages(VertexPages pages);
    /// Moves vertices to the pages of other pieces after a cut; call upload() next.
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
    gpu::Buffer blockSums;      ///< room for what is summed
    gpu::Buffer blockMeasures;  ///< the same; read by the CPU after each step

  private:
    void addRecord(const PieceModel& piece, std::size_t number, std::vector<std::uint32_t>& table);
    void makeRoomForSums();

    VertexPages pages_;
    std::vector<shared::PieceRecord> pieces_;
    std::vector<shared::BlockRecord> blocks_;
};

}  // namespace kerf
