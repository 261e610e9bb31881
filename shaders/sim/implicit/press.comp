// Lets the edge of a blade press in a step, by a row of contact for each vertex that answers much
// to it: a share of its spring, which never draws, and a share of the most that it presses with.
// Numbers: the substep, the first of the rows. One thread per vertex. A storage barrier follows.
#include "sim/base/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
#include "edge_records.h"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
layout(std430, binding = kLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kPressEdgeBinding) readonly buffer Edge { EdgeUniforms edge; };
layout(std430, binding = kPressWeightsBinding) readonly buffer Weights { float weights[]; };
layout(std430, binding = kPressStateBinding) readonly buffer State { EdgeState state; };
layout(std430, binding = kMadeRowsBinding) writeonly buffer Rows { vec4 rows[]; };
layout(std430, binding = kMadeRowVerticesBinding) writeonly buffer Vertices { uvec4 vertices[]; };

const float kLeastWeight = 1e-3;

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count) return;
    uint row = numbers.y + v;
    rows[kRowTexels * row + 1u] = vec4(0.0);
    float inverse = fetch(positions, v).w;
    bool answers = inverse > 0.0 && links[v].piece != kNoPiece && weights[v] > kLeastWeight;
    if (!answers) return;
    float share = weights[v] * massOf(inverse) / state.middle.w;
    float squared = implicit.step * implicit.step;
    float lag = edge.lag + edge.way * float(numbers.x) - state.gone;
    float most = max(share * edge.ahead.w / squared, 1e-30);
    rows[kRowTexels * row] = vec4(edge.ahead.xyz, -lag);
    rows[kRowTexels * row + 1u] = vec4(vec3(0.0), share / (edge.to.w * squared));
    rows[kRowTexels * row + 2u] = vec4(kOfObstacle, vec3(0.0));
    rows[kRowTexels * row + 3u] = vec4(edge.way * edge.ahead.xyz, -most);
    vertices[row] = uvec4(v);
}
