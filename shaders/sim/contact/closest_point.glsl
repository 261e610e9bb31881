#pragma once
// Barycentric weights of the point of the triangle abc closest to p, by the region of the plane
// (Ericson, Real-Time Collision Detection, 5.1.5). Takes a, b, c relative to p.
vec3 closestWeights(vec3 a, vec3 b, vec3 c) {
    vec3 ab = b - a;
    vec3 ac = c - a;
    float d1 = -dot(ab, a);
    float d2 = -dot(ac, a);
    if (d1 <= 0.0 && d2 <= 0.0) return vec3(1.0, 0.0, 0.0);
    float d3 = -dot(ab, b);
    float d4 = -dot(ac, b);
    if (d3 >= 0.0 && d4 <= d3) return vec3(0.0, 1.0, 0.0);
    float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        float s = d1 / (d1 - d3);
        return vec3(1.0 - s, s, 0.0);
    }
    float d5 = -dot(ab, c);
    float d6 = -dot(ac, c);
    if (d6 >= 0.0 && d5 <= d6) return vec3(0.0, 0.0, 1.0);
    float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        float s = d2 / (d2 - d6);
        return vec3(1.0 - s, 0.0, s);
    }
    float va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        float s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return vec3(0.0, 1.0 - s, s);
    }
    float sum = va + vb + vc;
    return vec3(va, vb, vc) / sum;
}
