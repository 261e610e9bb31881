// Constraints as lines, from the solver's own records. KIND: 0 edges (a line per corner of a
// triangle, of which one of two is drawn), 1 bends (from the middle of one triangle over the edge
// to that of the other), 2 ISPCs, 3 pulls of hands, 4 pairs of vertices.
#include "body_records.h"
#include "constraints.h"
#include "render_bindings.h"
#include "thick_line.glsl"
layout(std430, binding = kBindPositions) readonly buffer Positions { vec4 positions[]; };
#if KIND == 0
layout(std430, binding = kBindTriangles) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kBindRestPositions) readonly buffer Rest { vec4 restPositions[]; };
const int kLines = 1;
#elif KIND == 1
layout(std430, binding = kBindConstraints) readonly buffer Bends { BendRecord bends[]; };
const int kLines = 2;
#elif KIND == 2
layout(std430, binding = kBindConstraints) readonly buffer Ispcs { IspcConstraint ispcs[]; };
const int kLines = 1;
#elif KIND == 4
layout(std430, binding = kBindConstraints) readonly buffer Pairs { uvec2 pairs[]; };
const int kLines = 1;
#else
layout(std430, binding = kBindConstraints) readonly buffer Pulls { PullRecord pulls[]; };
const int kLines = 1;
#endif

uniform float showError;  // 1: colours tell the error
uniform float fullError;
uniform vec3 typeColor;
uniform vec3 shortColor;
uniform vec3 restColor;
uniform vec3 longColor;
out vec3 tone;

struct Line {
    bool drawn;
    vec3 from;
    vec3 to;
    float error;  // share of the rest length, or [rad]
};

vec3 at(uint vertex) { return positions[vertex].xyz; }

#if KIND == 0
Line lineOf(int index, int part) {
    uvec4 triangle = triangles[index / 3];
    uint a = triangle[index % 3];
    uint b = triangle[(index + 1) % 3];
    float rest = distance(restPositions[a].xyz, restPositions[b].xyz);
    return Line(a < b, at(a), at(b), distance(at(a), at(b)) / max(rest, 1e-12) - 1.0);
}
#elif KIND == 1
float bendError(BendRecord bend) {
    vec3 origin = at(bend.v0);
    vec3 e = at(bend.v1) - origin;
    vec3 left = cross(e, at(bend.v2) - origin);
    vec3 right = cross(at(bend.v3) - origin, e);
    float angle = atan(dot(cross(left, right), e) / max(length(e), 1e-12), dot(left, right));
    float error = angle - atan(bend.rest_sine, bend.rest_cosine);
    return error - 6.2831853 * round(error / 6.2831853);
}
Line lineOf(int index, int part) {
    BendRecord bend = bends[index];
    vec3 a = at(bend.v0);
    vec3 b = at(bend.v1);
    vec3 apex = at(part == 0 ? bend.v2 : bend.v3);
    return Line(true, 0.5 * (a + b), (a + b + apex) / 3.0, bendError(bend));
}
#elif KIND == 2
Line lineOf(int index, int part) {
    IspcConstraint ispc = ispcs[index];
    vec3 a = at(ispc.vertex);
    vec3 b =
        (1.0 - ispc.b1 - ispc.b2) * at(ispc.t0) + ispc.b1 * at(ispc.t1) + ispc.b2 * at(ispc.t2);
    return Line(true, a, b, distance(a, b) / max(ispc.rest_length, 1e-12) - 1.0);
}
#elif KIND == 4
Line lineOf(int index, int part) {
    return Line(true, at(pairs[index].x), at(pairs[index].y), 0.0);
}
#else
Line lineOf(int index, int part) {
    PullRecord pull = pulls[index];
    vec3 from = at(pull.vertex);
    vec3 target = vec3(pull.target_x, pull.target_y, pull.target_z);
    vec3 to = pull.leads == kForcePull ? from + target : target;
    return Line(pull.leads < kFirstBond, from, to, 0.0);  // bonds of tears are no hands
}
#endif

vec3 toneOf(float error) {
    float share = clamp(error / fullError, -1.0, 1.0);
    return mix(restColor, share < 0.0 ? shortColor : longColor, abs(share));
}

void main() {
    int quad = gl_VertexID / 6;
    Line line = lineOf(quad / kLines, quad % kLines);
    tone = showError > 0.0 ? toneOf(line.error) : typeColor;
    vec4 corner = lineCorner(line.from, line.to, gl_VertexID % 6);
    gl_Position = line.drawn ? corner : vec4(2, 2, 2, 1);
}
