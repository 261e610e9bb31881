#pragma once

namespace kerf::test {

/// How many objects of OpenGL the current context has, whoever made them.
struct GlObjects {
    int buffers = 0;
    int textures = 0;
    int framebuffers = 0;
    int vertexArrays = 0;
    int programs = 0;
    int queries = 0;

    /// Without queries: timers keep as many as a picture once had substeps.
    int lasting() const;
};

/// Counts them by their names, which drivers give out in ascending order and anew.
GlObjects countGlObjects();

}  // namespace kerf::test
