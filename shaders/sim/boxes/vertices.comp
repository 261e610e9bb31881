// Keeps vertices out of boxes (keep_out.glsl). Reads X, X at the beginning of the substep, links,
// boxes of pieces, boxes. Reads and writes d. Writes the way since that beginning. One thread per
// vertex. A storage barrier follows.
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kBoxBoxesBinding) readonly buffer Boxes { BoxRecord boxes[]; };
layout(std430, binding = kBoxLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kBoxPiecesBinding) readonly buffer Bounds { PieceBounds bounds[]; };
layout(std430, binding = kBoxStartBinding) buffer Start { vec4 start[]; };

vec4 positionOf(uint v) { return positions[v]; }
vec4 displacementOf(uint v) { return displacement[v]; }
uint pieceOf(uint v) { return links[v].piece; }
BoxRecord boxAt(uint b) { return boxes[b]; }
PieceBounds pieceBounds(uint p) { return bounds[p]; }

#include "keep_out.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= obstacle.vertex_count || positions[v].w == 0.0) return;
    vec3 d = outOfBoxes(v);
    displacement[v] = vec4(d, 0.0);
    start[v].w = distance(start[v].xyz, positions[v].xyz) + length(d);
}
