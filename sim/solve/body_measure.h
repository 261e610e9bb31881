#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "shaders/shared/body_records.h"
#include "sim/base/math.h"
#include "sim/mesh/oriented_box.h"
#include "sim/solve/collisions.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// Positions and velocities of some vertices, each once, ascending.
struct VertexStates {
    std::vector<shared::NearbyVertex> records;
    /// Whether it is complete; otherwise there were too many near the box.
    bool complete = true;
};

/// A query of the CPU for vertices on the GPU, and a buffer for the result.
class NearbyVertices {
  public:
    NearbyVertices();

    /// Queries the vertices of all triangles that meet `box`, if any, and those in `asked`.
    void ask(const std::optional<OrientedBox>& box, std::span<const int> asked);
    /// Repeats the query, without previous results.
    void renew();
    /// Whether there is a query at all.
    bool asks() const { return query_.asks_for_box != 0 || query_.asked_vertices > 0; }
    /// The number of vertices in `asked`.
    std::uint32_t asked() const { return query_.asked_vertices; }
    void bind() const;
    /// Requests the result in its expected size; the kernels have the query already.
    void askFor(gpu::ReadBack& back);
    /// The result; waits for the GPU, and reads again if it is longer than expected. Ends the
    /// query.
    VertexStates take(const gpu::ReadBack& back);

  private:
    shared::NearbyQuery query_{};
    gpu::Buffer buffer_;
    /// Expected size of the next result: somewhat longer than the last one.
    std::uint32_t expected_ = kLeastExpected;
    std::uint32_t sent_ = 0;  ///< requested records of the result
    std::size_t place_ = 0;   ///< of the result
    static constexpr std::uint32_t kLeastExpected = 4096;
};

/// The numbers that the CPU gets from the GPU after a step, without reading the body back.
struct BodyMeasure {
    std::vector<double> pieceVolumes;  ///< [m^3]
    std::vector<Bounds> pieceBounds;   ///< [m]
    Bounds bounds;                     ///< of the living triangles [m]
    double fastest = 0;                ///< no vertex is faster [m/s]
    /// Pieces with a vertex that is not finite or faster than runawaySpeed(), or that have grown
    /// beyond kLargestPiece; ascending.
    std::vector<int> lostPieces;
    int contacts = 0;          ///< of the body with itself in the last substep
    double kineticEnergy = 0;  ///< of the vertices that are free to move [J]
    /// The energy of free vertices in the field of gravity above the floor, or above 0 [J].
    double potentialEnergy = 0;
    /// The energy of the strained material: the sum of C^2 / (2 alpha) over edges, bends and ISPCs
    /// that are on and not rigid; means nothing with plain PBD [J].
    double strainEnergy = 0;
    /// Of an edge, as a share of its length or of a quarter of the edge length of walls, which is
    /// more: a sliver's short edge says nothing about the material.
    double largestStretch = 0;

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(pieceVolumes, pieceBounds, bounds, fastest, lostPieces, contacts, kineticEnergy,
           potentialEnergy, strainEnergy, largestStretch);
    }
};

/// A piece whose box is longer than this many diagonals of the uncut body has diverged.
inline constexpr double kLargestPiece = 20;

/// Measures a body on the GPU, passes bounds to its collisions for the next step, and reads the
/// state of some vertices back.
class BodyMeasurer {
  public:
    /// Both must outlive it. Compiles the kernels: throws gpu::ShaderError.
    BodyMeasurer(SolverBody& body, Collisions& collisions);

    /// Starts the measure on the GPU, between steps. Meanwhile the CPU may do other work that
    /// changes nothing here.
    void start();
    /// The measure started by start(), with unchanged pieces; waits for the GPU.
    BodyMeasure take();
    /// What iterations of the step before left unsolved, of its motion: the root of the share of
    /// its energy, before the last iteration. `least`: less energy is no motion [J]. None before
    /// the first implicit step.
    std::optional<double> residual(double least) const;
    /// Makes the coming start() also read what takeWatched() returns; see NearbyVertices.
    void watch(const std::optional<OrientedBox>& box, std::span<const int> vertices) {
        nearby_.ask(box, vertices);
    }
    /// The watched vertices as of the last take(). Once for each watch().
    VertexStates takeWatched() { return nearby_.take(back_); }
    /// Makes the coming start() also read the state of all vertices, which takeAll() returns.
    void watchAll() { watchesAll_ = true; }
    /// The state as of the last take(). Once for each watchAll().
    BodyState takeAll();
    /// Positions and velocities of these vertices; waits for the GPU.
    VertexStates statesOf(std::span<const int> vertices);
    /// The states of all vertices of triangles that meet `box`; waits for the GPU. Between steps.
    VertexStates statesNear(const OrientedBox& box);

  private:
    void bindConstraints() const;
    void collect(NearbyVertices& query, gpu::ReadBack& back);

    SolverBody& body_;
    Collisions& collisions_;
    gpu::Program measure_, collect_;
    gpu::ReadBack back_;           ///< of start()
    std::size_t place_ = 0;        ///< of the block measures there
    std::size_t courses_ = 0;      ///< their place there
    std::size_t courseCount_ = 0;  ///< 0 before the first implicit step
    NearbyVertices nearby_;        ///< of the coming start()
    bool watchesAll_ = false;
    SolverState::Offsets all_;  ///< of all vertices there
    NearbyVertices collected_;  ///< of statesOf()
    gpu::ReadBack collectedBack_;
};

}  // namespace kerf
