#pragma once

#include <cstdint>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "sim/solve/body_view.h"

namespace kerf::render {

/// How finely triangles of coarse bodies are divided where they are shown, to look round: into the
/// square of `mostSidePieces` at most, and into about `shownTriangles` in all.
struct Roundness {
    double shownTriangles = 12000;
    int mostSidePieces = 2;
};

/// What is drawn of the running body's surface besides its own buffers: normals and rims of cuts.
class NormalsPass {
  public:
    explicit NormalsPass(const Roundness& roundness = {});
    /// Skin has hard edges where its faces met at more than so many degrees at rest. `flat`: coarse
    /// skin is not to look round.
    void run(const BodyView& body, double hardEdges, bool flat);

    /// vec4, shape [2 * vertexCount]: entry 2 * vertex + kind, over skin and over wall triangles;
    /// w of the first: 1 where the skin is smooth there, 0 at hard edges and where there is none; w
    /// of the second: how far above it the skin is shown where it is drawn round [m].
    const gpu::Buffer& normals() const { return normals_; }
    /// uvec4, a command of glDrawArraysIndirect whose instances are the edges on the rims of cuts;
    /// behind it normals of the corners of the skin, and the rims (skin_corners.glsl).
    const gpu::Buffer& skinCorners() const { return skinCorners_; }
    /// Into how many a side of a triangle is divided where it is shown; coarse skin looks round so.
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
