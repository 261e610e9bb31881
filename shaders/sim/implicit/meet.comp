// What each vertex meets in a step where all is at X + h v: the floor, the nearest of its candidate
// triangles, and the edge that an edge at it comes nearest to. Joins the pieces that may touch, and
// begins to count contacts. With UNFOLDS folded skin rubs on no floor.
// Numbers: whether candidates are there. One thread per vertex. A storage barrier follows.
#include "sim/base/numbers.glsl"
#include "contact_records.h"
#include "contact_bindings.h"
#include "implicit_records.h"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMeetContactBinding) readonly buffer Contact { ContactUniforms contact; };
layout(std430, binding = kMeetStateBinding) writeonly buffer State { ContactState state; };
layout(std430, binding = kMadeRowsBinding) writeonly buffer Rows { vec4 rows[]; };
layout(std430, binding = kParentsBinding) coherent buffer Parents { uint parents[]; };
#include "sim/implicit/made_rows.glsl"
uint pieceOf(uint v) { return links[v].piece; }
#include "sim/contact/crossing.glsl"
#include "sim/implicit/join.glsl"

// How far the skin at a vertex is folded, 0 to 1, when the step begins. Where it is, the floor does
// not rub, and neither the walls of a slit nor others of the same piece touch: friction holds what
// the springs that unfold press onto the floor, and a wall that has turned over is caught behind
// them. Kernels with UNFOLDS are compiled for steps that unfold; to others nothing is folded.
#ifdef UNFOLDS
layout(binding = kFoldsUnit) uniform usamplerBuffer folds;
float foldAt(uint v) { return uintBitsToFloat(texelFetch(folds, int(v)).x); }
#else
float foldAt(uint v) { return 0.0; }
#endif

float foldAt(uvec4 v) {
    return max(max(foldAt(v.x), foldAt(v.y)), max(foldAt(v.z), foldAt(v.w)));
}

// Whether one of the two is folded and would be caught by the other: folded skin touches neither
// what was beside it at rest nor its own piece.
bool passesFold(uint v, Nearest near) {
#ifdef UNFOLDS
    bool wasBeside = near.thickness < contact.thickness;
    bool ownPiece = pieceOf(v) == near.triangle.w >> 8;
    return (wasBeside || ownPiece) && foldAt(uvec4(v, near.triangle.xyz)) > 0.0;
#else
    return false;
#endif
}

void meetFloor(uint v) {
    float gap = positionOf(v).y - implicit.contact.floor_height;
    float approach = -displacementOf(v).y;
    if (!(gap < implicit.contact.reach + 1.5 * approach)) return;
    uint row = kRowsOfVertex * v + kMeetsObstacle;
    setRow(row, Met(vec3(0.0, 1.0, 0.0), gap, firmnessOf(v), vec4(kOfObstacle, vec3(0.0)),
                    vec3(0.0), foldAt(v) > 0.0, kLetOut));
    vertices[row] = uvec4(v);
}

void meetSurface(uint v, uint piece) {
    Nearest near = nearest(v);
    bool meets = dot(near.weights, vec3(1.0)) > 0.5 &&
        lateralDistance(near) <= kLateralSlack * contact.h && !passesFold(v, near);
    if (!meets) return;
    uvec4 t = near.triangle;
    vec3 own = positionOf(v).xyz;
    vec3 a = positionOf(t.x).xyz - own;
    vec3 areaNormal = cross(positionOf(t.y).xyz - own - a, positionOf(t.z).xyz - own - a);
    vec3 normal = areaNormal / max(length(areaNormal), 1e-30);
    uint row = kRowsOfVertex * v + kMeetsTriangle;
    setRow(row, Met(normal, -dot(normal, a) - near.thickness,
                    together(firmnessOf(v), firmnessOf(t.xyz, near.weights)),
                    vec4(float(t.w >> 8), -near.weights), vec3(0.0), false, kLetOut));
    vertices[row] = uvec4(v, t.xyz);
    join(piece, t.w >> 8);
}

// Edges that come no nearer than they may are met too: elasticity may take them there. They let
// nothing out: where a crumpled body lies in itself others come nearest in each step, and each
// would give it speed.
void meetEdge(uint v, uint piece) {
    Crossing near = mostUrgent(v, -contact.thickness);
    if (!(near.lack > -contact.thickness)) return;
    uvec4 ends = near.vertices;
    vec4 share = abs(near.gains);
    uint row = kRowsOfVertex * v + kMeetsEdge;
    setRow(row, Met(near.normal, near.before - near.thickness,
                    together(share.x * firmnessOf(v) + share.y * firmnessOf(ends.y),
                             share.z * firmnessOf(ends.z) + share.w * firmnessOf(ends.w)),
                    vec4(float(near.piece), near.gains.yzw), vec3(0.0), true, 0.0));
    vertices[row] = ends;
    join(piece, near.piece);
}

bool touchesItself = numbers.x != 0u;

// Lists of candidates of edges are there where there are candidates.
bool hasCandidates(uint v) { return candidateAt(kCandidatesPerPoint * v).triangle != kNoVertex; }

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count) return;
    uint piece = links[v].piece;
    if (v == 0u) state.last_contacts = 0u;
    for (uint k = 0u; k < kRowsOfVertex; ++k) setNone(kRowsOfVertex * v + k);
    if (piece == kNoPiece) return;
    meetFloor(v);
    if (!touchesItself || !hasCandidates(v)) return;
    meetSurface(v, piece);
    meetEdge(v, piece);
}
