// The box around each piece, for vertices.comp. Reads X, links. Writes boxes of pieces, which begin
// empty. One thread per vertex; a minimum does not mind the order in which threads come. A storage
// barrier follows.
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kBoxPiecesBinding) coherent buffer Bounds { PieceBounds bounds[]; };

#include "sim/base/ordered_floats.glsl"

// Most vertices lie inside of what is known already.
void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= obstacle.vertex_count || links[v].piece == kNoPiece) return;
    uint p = links[v].piece;
    uint x = orderedWord(positions[v].x);
    uint y = orderedWord(positions[v].y);
    uint z = orderedWord(positions[v].z);
    if (x < bounds[p].low_x) atomicMin(bounds[p].low_x, x);
    if (y < bounds[p].low_y) atomicMin(bounds[p].low_y, y);
    if (z < bounds[p].low_z) atomicMin(bounds[p].low_z, z);
    if (x > bounds[p].high_x) atomicMax(bounds[p].high_x, x);
    if (y > bounds[p].high_y) atomicMax(bounds[p].high_y, y);
    if (z > bounds[p].high_z) atomicMax(bounds[p].high_z, z);
}
