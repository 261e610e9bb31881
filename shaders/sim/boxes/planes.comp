// Planes between triangles and boxes, as both lay when the substep began: corners that stay behind
// them take no triangle across a box, however thin it is and however sharply the skin bends around
// it. A plane lies across the axis along which the two are farthest apart: a face of the box, the
// triangle, or across an edge of each. Where they overlap a little along all of them, as what
// touches may, the plane goes through the triangle.
//
// A corner may take a share of the gap. Planes that corners do not get to in this substep are left
// out; of others each triangle keeps the three that leave the least.
// Reads X at the beginning of the substep and ways since, triangles, boxes. Writes planes, marks
// vertices in shares. With OF_STEP ways are those of X, in an implicit step. One thread per
// triangle. A storage barrier follows, then sides.
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kBoxBoxesBinding) readonly buffer Boxes { BoxRecord boxes[]; };
layout(std430, binding = kBoxRecordsBinding) writeonly buffer Planes { BoxPlanes planes[]; };
layout(std430, binding = kBoxSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kBoxStartBinding) readonly buffer Start { vec4 start[]; };
#ifdef OF_STEP
layout(std430, binding = kBoxPositionsBinding) readonly buffer Positions { vec4 positions[]; };
float wayOf(uint v) { return distance(start[v].xyz, positions[v].xyz); }
#else
float wayOf(uint v) { return start[v].w; }
#endif

#include "boxes.glsl"
#include "separation.glsl"

// Share of a gap that corners may take in a substep, down to a share of the thickness.
const float kTaken = 0.9;
const float kLeft = 0.1;
// Overlaps up to here are touches, as kSkinDeep says: a share of the box's least half length.
const float kOverlap = 0.5;

// How far corners may go towards the box [m].
float roomAt(Plane plane) { return kTaken * max(plane.gap - kLeft * obstacle.thickness, 0.0); }

float deepestTouch(vec3 reach) {
    return min(kOverlap * min(reach.x, min(reach.y, reach.z)), kSkinDeep * obstacle.depth);
}

// xyz: normal, w: room of what a corner that goes up to `way` far may get to; kNoPlane: of nothing.
vec4 planeTo(BoxRecord box, vec3 p[3], float way) {
    vec3 reach = halfOf(box);
    for (int k = 0; k < 3; ++k) p[k] = toBox(box, p[k] - box.center.xyz);
    Plane best = facePlane(p, reach);
    // A loop, since llvmpipe runs both sides of a branch.
    for (int i = roomAt(best) < way ? 0 : 1; i < 1; ++i) best = widestPlane(best, p, reach);
    bool counts = roomAt(best) < way && best.gap > -deepestTouch(reach);
    return vec4(fromBox(box, best.normal), counts ? roomAt(best) : kNoPlane);
}

// The three with the least room, in their order. No array is passed that changes: NVIDIA's
// compilers took such for others.
BoxPlanes keep(BoxPlanes least, vec4 plane) {
    bool first = plane.w < least.first.w;
    bool second = plane.w < least.second.w;
    bool third = plane.w < least.third.w;
    return BoxPlanes(first ? plane : least.first,
                     first ? least.first : (second ? plane : least.second),
                     second ? least.second : (third ? plane : least.third));
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= obstacle.triangle_count) return;
    uvec3 t = triangles[index].xyz;
    vec3 p[3] = vec3[3](start[t.x].xyz, start[t.y].xyz, start[t.z].xyz);
    float way = max(wayOf(t.x), max(wayOf(t.y), wayOf(t.z)));
    BoxPlanes least = BoxPlanes(vec4(kNoPlane), vec4(kNoPlane), vec4(kNoPlane));
    for (uint i = 0u; i < obstacle.box_count; ++i) {
        least = keep(least, planeTo(boxes[i], p, way));
    }
    planes[index].first = least.first;
    if (least.first.w == kNoPlane) return;
    planes[index].second = least.second;
    planes[index].third = least.third;
    for (int k = 0; k < 3; ++k) atomicMax(shares[t[k]], 1u);  // others mark it too
}
