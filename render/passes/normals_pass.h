#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/solve/body_view.h"

namespace kerf::render {

/// The subdivision of triangles of coarse bodies for display, to look round: into the square of
/// `mostSidePieces` at most, and into about `shownTriangles` in all.
struct Roundness {
    double shownTriangles = 12000;
    int mostSidePieces = 2;
};

/// Derived data for drawing the body's surface: normals and rims of cuts.
class NormalsPass {
  public:
    explicit NormalsPass(const Roundness& roundness = {});
    /// Skin has hard edges where its faces met at more than `hardEdges` degrees at rest. `flat`:
    /// coarse skin does not look round.
    void run(const BodyView& body, double hardEdges, bool flat);

    /// vec4, shape [2 * vertexCount]: entry 2 * vertex + kind, over skin and over wall triangles; w
    /// of the first: 1 on smooth skin, 0 at hard edges and without skin; w of the second: the
    /// height of round skin above it [m].
    const gpu::Buffer& normals() const { return normals_; }
    /// uvec4, a command of glDrawArraysIndirect whose instances are the edges on the rims of cuts;
    /// behind it normals of the corners of the skin, and the rims (skin_corners.glsl).
    const gpu::Buffer& skinCorners() const { return skinCorners_; }
    /// The number of parts of a triangle's side for display, so that coarse skin looks round.
    int sidePieces() const { return sidePieces_; }

  private:
    int sidePiecesOf(std::uint32_t triangles) const;

    gpu::Program program_;
    Roundness roundness_;
    gpu::Buffer normals_;
    gpu::Buffer skinCorners_;
    int sidePieces_ = 1;
};

}  // namespace kerf::render
