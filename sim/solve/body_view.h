#pragma once

#include "gpu/buffer.h"
#include "sim/contact/contact_solver.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The buffers of the running body that the renderer draws from: the solver's own, never copied.
/// Triangle slots are compacted (living triangles only).
struct BodyView {
    const gpu::Buffer* positions = nullptr;       ///< vec4: xyz current [m], w inverse unit mass
    const gpu::Buffer* restPositions = nullptr;   ///< vec4 per vertex: xyz rest [m]
    const gpu::Buffer* cutSkinNormals = nullptr;  ///< vec4: see BodyModel::cutSkinNormals
    /// uvec4 per triangle: three vertices; w = surfaceTag() | piece << 8.
    const gpu::Buffer* triangles = nullptr;
    /// The triangles around each vertex: per vertex the first and the end place in `incidence`,
    /// whose entries are 4 * triangle + corner. Fixed order: normals are the same bits every time.
    const gpu::Buffer* incidenceRanges = nullptr;
    const gpu::Buffer* incidence = nullptr;
    std::uint32_t vertexCount = 0;
    std::uint32_t triangleCount = 0;
};

/// The buffers of the constraints on the running body: the solver's own, for overlays. A buffer
/// without entries may be null. Edges are those of the triangles (see BodyView).
struct ConstraintView {
    const gpu::Buffer* bends = nullptr;         ///< BendRecord
    const gpu::Buffer* ispcs = nullptr;         ///< IspcConstraint
    const gpu::Buffer* pulls = nullptr;         ///< PullRecord, of the last step
    const gpu::Buffer* contacts = nullptr;      ///< ContactRecord, of the last substep
    const gpu::Buffer* contactState = nullptr;  ///< ContactState: how many of them count
    std::uint32_t bendCount = 0;
    std::uint32_t ispcCount = 0;
    std::uint32_t pullCount = 0;
    std::uint32_t mostContacts = 0;  ///< 0 where contact is off
};

// The buffers of a body on the GPU as those see them who work on it or draw it; valid while the
// body is neither uploaded nor updated.

ContactBody contactBodyOf(const SolverBody& body);
BodyView bodyViewOf(const SolverBody& body);
/// The constraints to draw, with `contacts` if they are on and were searched.
ConstraintView constraintViewOf(const SolverBody& body, const ContactSolver& contacts);

}  // namespace kerf
