#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "sim/base/math.h"
#include "sim/solve/collisions.h"
#include "sim/solve/nearby_vertices.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The numbers that the CPU learns from the GPU after a step, without reading the body back.
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
};

/// A piece whose box is longer than this many diagonals of the uncut body has run away.
inline constexpr double kLargestPiece = 20;

/// Measures a body on the GPU, tells its collisions what the next step may meet, and brings the
/// state of some of its vertices back.
class BodyMeasurer {
  public:
    /// Both must outlive it. Compiles the kernels: throws gpu::ShaderError.
    BodyMeasurer(SolverBody& body, Collisions& collisions);

    /// Lets the GPU begin to measure the positions between steps. Meanwhile the CPU may do
    /// something else that changes nothing here.
    void start();
    /// The measure that start() asked for, with the same pieces still; waits for the GPU.
    BodyMeasure take();
    /// Has the coming start() find out besides what takeWatched() gives; see NearbyVertices.
    void watch(const std::optional<OrientedBox>& box, std::span<const int> vertices) {
        nearby_.ask(box, vertices);
    }
    /// The watched vertices as of the last take(). Once for each watch().
    VertexStates takeWatched() { return nearby_.take(back_); }
    /// Has the coming start() bring the state of all vertices too, which takeAll() gives.
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
    gpu::ReadBack back_;     ///< of start()
    std::size_t place_ = 0;  ///< of the block measures there
    NearbyVertices nearby_;  ///< of the coming start()
    bool watchesAll_ = false;
    SolverState::Places all_;   ///< of all vertices there
    NearbyVertices collected_;  ///< of statesOf()
    gpu::ReadBack collectedBack_;
};

}  // namespace kerf
