// The inverse mass of every vertex at density 1, from its rest area and two numbers of its piece:
// after a cut all masses of a piece change, but only few areas.
// Reads links, areas, pieces. Writes w of the positions. One thread per vertex. A storage barrier
// follows.
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kAreasBinding) readonly buffer Areas { float areas[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    float inverse = 0.0;
    if (links[v].piece != kNoPiece) {
        PieceRecord piece = pieces[links[v].piece];
        float mass = piece.mass_per_area * max(areas[v], piece.least_area);
        inverse = mass > 0.0 ? 1.0 / mass : 0.0;
    }
    positions[v].w = inverse;
}
