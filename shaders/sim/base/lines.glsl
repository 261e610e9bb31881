#pragma once
// How far along two lines, from p along u and from q along v, they come nearest to each other.
vec2 nearestOnLines(vec3 p, vec3 u, vec3 q, vec3 v) {
    vec3 r = p - q;
    float uu = dot(u, u);
    float vv = dot(v, v);
    float uv = dot(u, v);
    float scale = uu * vv - uv * uv;
    float s = (uv * dot(v, r) - vv * dot(u, r)) / scale;
    return vec2(s, (dot(v, r) + s * uv) / vv);
}
