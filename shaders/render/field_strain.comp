// How far the surface around each vertex is strained against rest, over skin and over wall
// triangles: the mean of their triangles, each weighted by its area at rest. AREA: the change of
// area, otherwise the larger principal strain. Reads positions, rest positions, triangles,
// incidence; writes field values, 2 * vertex + kind, and their areas. One thread per vertex; a
// storage barrier follows. The gather runs in the order of the incidence list.
#include "render_bindings.h"
layout(local_size_x = kNormalsGroupSize) in;

#define FIELD_ACCESS
#include "body.glsl"
#include "field.glsl"
layout(std430, binding = kBindRestPositions) readonly buffer RestPositions {
    vec4 restPositions[];
};
layout(std430, binding = kBindIncidenceRanges) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = kBindIncidence) readonly buffer Entries { uint entries[]; };

uniform uint vertexCount;

// Squared lengths of two sides, and their product: what a shape is but for where it lies.
vec3 gram(vec3 u, vec3 v) {
    return vec3(dot(u, u), dot(u, v), dot(v, v));
}

// Of the symmetric matrices (x y; y z): what d adds to g, seen in g: half the trace of g^-1 d, and
// its determinant.
vec2 change(vec3 g, vec3 d, float det) {
    return vec2(0.5 * (g.z * d.x - 2.0 * g.y * d.y + g.x * d.z), d.x * d.z - d.y * d.y) / det;
}

// sqrt(1 + x) - 1, to the last digit where x is small.
float rootMinusOne(float x) {
    return x / (1.0 + sqrt(max(1.0 + x, 0.0)));
}

const float kFlattest = 1e-6;  // squared sine between two sides

// Weighted by the area at rest, which comes second.
vec2 strainOf(uvec4 triangle) {
    vec3 a = restPositions[triangle.x].xyz;
    vec3 rest = gram(restPositions[triangle.y].xyz - a, restPositions[triangle.z].xyz - a);
    float det = rest.x * rest.z - rest.y * rest.y;
    if (!(det > kFlattest * rest.x * rest.z)) {
        return vec2(0);  // of a sliver, floats tell nothing
    }
    vec3 p = positions[triangle.x].xyz;
    vec3 now = gram(positions[triangle.y].xyz - p, positions[triangle.z].xyz - p);
    vec2 c = change(rest, now - rest, det);
    float area = 0.5 * sqrt(det);
#ifdef AREA
    return area * vec2(rootMinusOne(2.0 * c.x + c.y), 1.0);
#else
    float spread = sqrt(max(c.x * c.x - c.y, 0.0));
    float most = abs(rootMinusOne(c.x + spread));
    float least = abs(rootMinusOne(max(c.x - spread, -1.0)));
    return area * vec2(max(most, least), 1.0);
#endif
}

void store(uint place, vec2 sum) {
    fieldValues[place] = sum.y > 0.0 ? sum.x / sum.y : kNoField;  // no such triangle is there
    fieldValues[2u * vertexCount + place] = sum.y;
}

void main() {
    uint vertex = gl_GlobalInvocationID.x;
    if (vertex >= vertexCount) {
        return;
    }
    vec2 sums[2] = vec2[](vec2(0), vec2(0));
    for (uint i = ranges[vertex].x; i < ranges[vertex].y; ++i) {
        uvec4 triangle = triangles[entries[i] / 4u];
        sums[triangle.w & 1u] += strainOf(triangle);
    }
    store(2u * vertex, sums[0]);
    store(2u * vertex + 1u, sums[1]);
}
