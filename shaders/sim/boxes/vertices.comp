// Keeps vertices out of boxes: d ends at the face that the way from X to X + d enters through, a
// thickness away from it. What starts inside comes out through the nearest face, slowly. Coulomb friction shortens the tangential way.
// Reads X, boxes. Reads and writes d. One thread per vertex; boxes in their order. A storage barrier
// follows.
#include "body_records.h"
#include "box_records.h"
layout(local_size_x = kGroupSize) in;

#include "sim/boxes/uniforms.glsl"
layout(std430, binding = kBoxPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kBoxBoxesBinding) readonly buffer Boxes { BoxRecord boxes[]; };

#include "boxes.glsl"

// A face that stops a vertex; axis 3 for none.
struct Face {
    int axis;
    float gap;  // to it at X [m]
};

int largest(vec3 v) {
    return v.x >= v.y && v.x >= v.z ? 0 : (v.y >= v.z ? 1 : 2);
}

// The last of the three slabs that the way enters is where it meets the box.
Face entered(vec3 at, vec3 way, vec3 reach) {
    vec3 outside = abs(at) - reach;
    vec3 inward = -sign(at) * way;
    vec3 when = vec3(-1.0);
    for (int k = 0; k < 3; ++k) {
        if (outside[k] > 0.0) {
            if (!(inward[k] > outside[k])) return Face(3, 0.0);
            when[k] = outside[k] / inward[k];
        }
    }
    int axis = largest(when);
    vec3 beside = abs(at + when[axis] * way) - reach;
    beside[axis] = 0.0;
    return Face(all(lessThanEqual(beside, vec3(0.0))) ? axis : 3, outside[axis]);
}

Face faceFor(vec3 at, vec3 way, vec3 reach) {
    vec3 outside = abs(at) - reach;
    int axis = largest(outside);
    return outside[axis] > 0.0 ? entered(at, way, reach) : Face(axis, outside[axis]);
}

vec3 keptOut(BoxRecord box, vec3 x, vec3 d) {
    vec3 at = toBox(box, x - box.center.xyz);
    vec3 way = toBox(box, d);
    Face face = faceFor(at, way, halfOf(box) + uniforms.thickness);
    if (face.axis == 3) return d;
    float side = at[face.axis] < 0.0 ? -1.0 : 1.0;
    float least = min(-face.gap, uniforms.lift);
    float lift = least - side * way[face.axis];
    if (!(lift > 0.0)) return d;
    float across = way[face.axis];
    way[face.axis] = 0.0;
    way *= slipLeft(length(way), lift, uniforms.friction);
    way[face.axis] = across + side * lift;
    return fromBox(box, way);
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count || positions[v].w == 0.0) return;
    vec3 x = positions[v].xyz;
    vec3 d = displacement[v].xyz;
    for (uint b = 0u; b < uniforms.box_count; ++b) {
        d = keptOut(boxes[b], x, d);
    }
    displacement[v] = vec4(d, 0.0);
}
