#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/contact_tree.h"

namespace kerf {

/// The settings as the kernels read them; counts are 0. `edgeLength`: see contactEdgeLength() [m].
shared::ContactUniforms paperContactUniforms(const ContactSettings& settings, double edgeLength);

/// The paper's response to contact between pieces, on the GPU, for comparison with ContactSolver:
/// once a time step, with the same bits for any number of threads.
///
/// Broad phase: boxes of the pieces, then a tree of boxes over the triangles, in the place of the
/// paper's octree, which has to be built anew. Narrow phase: an edge of one triangle
/// meets the other one (Möller and Trumbore, 1997). Two triangles that approach each other lose
/// their relative mean velocity, each by half of it. All that intersect are pushed apart along the
/// difference of their normals: pushed against their velocity, as the paper may mean, bodies deep
/// in each other gained energy and stayed there. No pair is pushed by more than a share of an edge.
/// A vertex takes the mean over its triangles: of the loss in velocity and position, of the push
/// only in position. Walls of a slit and limbs of one piece do not collide. Pinned vertices stay.
/// Floats and fixed point agree with the reference in doubles
/// (tests/support/reference/reference_paper_contact.h) to 1e-6 m and 2e-4 m/s.
class PaperContact {
  public:
    PaperContact();

    /// A new body, or one with changed triangles.
    void setBody(const ContactBody& body, double edgeLength);
    void setSettings(const ContactSettings& settings) { settings_ = settings; }
    bool enabled() const { return settings_.paper; }

    /// Responds to contact between two time steps. `pieces`: how many it has. Compiles the kernels
    /// with the first two pieces: throws gpu::ShaderError, gpu::OutOfMemory.
    void respond(std::uint32_t pieces);

    /// Counts of the last response: a ContactState, of which `last_contacts` is the number of
    /// intersecting pairs of triangles.
    const gpu::Buffer& state() const { return state_; }

  private:
    struct Kernels {
        gpu::Program pieces, meet, answer;
        ContactTree tree;
    };
    void makeRoom(std::uint32_t pieces);
    void bind() const;

    std::optional<Kernels> kernels_;
    ContactBody body_;
    bool bodyIsNew_ = false;  ///< since the last response
    ContactSettings settings_;
    double edgeLength_ = 0;  ///< [m]
    gpu::Buffer uniforms_, state_;
    gpu::Buffer pieceBounds_;
    gpu::Buffer asked_;  ///< response of each triangle to its partners
};

}  // namespace kerf
