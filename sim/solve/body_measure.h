#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/base/math.h"
#include "sim/solve/nearby_vertices.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The numbers that the CPU learns from the GPU after a step, without reading the body back.
struct BodyMeasure {
    std::vector<double> pieceVolumes;  ///< [m^3]
    std::vector<Bounds> pieceBounds;   ///< [m]
    Bounds bounds;                     ///< of the living triangles [m]
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

/// A measure, with what the next step of the solver counts on.
struct SolverMeasure {
    BodyMeasure body;
    Bounds velocities;    ///< of all vertices [m/s]
    Bounds ways;          ///< that they went since contacts were looked for [m]
    bool folded = false;  ///< some edge is folded (see Unfolding)
    bool hasCandidates = false;
};

/// What a measure reads of contact between the parts of a body.
struct ContactReadings {
    const gpu::Buffer& state;     ///< a ContactState: its counts
    const gpu::Buffer& searched;  ///< X when candidates were looked for; of some size where never
    bool counts;                  ///< whether contact is on
};

/// Measures a body on the GPU, and brings the state of some of its vertices back.
class BodyMeasurer {
  public:
    /// The body must outlive it. Compiles the kernels: throws gpu::ShaderError.
    explicit BodyMeasurer(SolverBody& body);

    /// Lets the GPU begin to measure the positions between steps.
    void start(const ContactReadings& contacts);
    /// The measure that start() asked for, with the same pieces still; waits for the GPU.
    SolverMeasure take(const ContactReadings& contacts) const;
    /// See GpuSolver.
    void watch(const std::optional<OrientedBox>& box, std::span<const int> vertices) {
        nearby_.ask(box, vertices);
    }
    VertexStates takeWatched() { return nearby_.take(); }
    VertexStates statesOf(std::span<const int> vertices);
    VertexStates statesNear(const OrientedBox& box, const ContactReadings& contacts);

  private:
    void bindConstraints() const;
    void collectAsked(const NearbyVertices& query);

    SolverBody& body_;
    gpu::Program measure_, collect_;
    int slot_ = 0;              ///< of the block measures that start() asked for
    NearbyVertices nearby_;     ///< of the coming start()
    NearbyVertices collected_;  ///< of statesOf()
};

}  // namespace kerf
