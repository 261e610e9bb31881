#pragma once
// Weights of the point of the plane of the triangle abc that lies below or above p; one outside the
// triangle has a weight below 0.
vec3 planeWeights(vec3 a, vec3 b, vec3 c, vec3 p) {
    vec3 normal = cross(b - a, c - a);
    float scale = 1.0 / max(dot(normal, normal), 1e-30);
    float v = dot(cross(p - a, c - a), normal) * scale;
    float w = dot(cross(b - a, p - a), normal) * scale;
    return vec3(1.0 - v - w, v, w);
}
