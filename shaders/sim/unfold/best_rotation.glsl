#pragma once
// Rotations as quaternions, real part last.

vec3 rotated(vec4 q, vec3 a) {
    vec3 t = 2.0 * cross(q.xyz, a);
    return a + q.w * t + cross(q.xyz, t);
}

// The rotation that brings points closest to others, of which `sx`, `sy` and `sz` are the sums of m
// point.x other, m point.y other and m point.z other: the eigenvector of the largest eigenvalue of
// a symmetric matrix (Horn 1987). Squaring the matrix again and again leaves that one alone. It
// needs no start, takes flat and thin sets of points, and never mirrors them.
vec4 bestRotation(vec3 sx, vec3 sy, vec3 sz) {
    const uint kSquarings = 12u;
    float size = sqrt(dot(sx, sx) + dot(sy, sy) + dot(sz, sz));
    float scale = size > 0.0 ? 1.0 / size : 0.0;
    sx *= scale;
    sy *= scale;
    sz *= scale;
    vec3 turn = vec3(sy.z - sz.y, sz.x - sx.z, sx.y - sy.x);
    float xy = sx.y + sy.x;
    float yz = sy.z + sz.y;
    float zx = sz.x + sx.z;
    // Plus 1: then no negative eigenvalue is the largest in size.
    mat4 m = mat4(vec4(1.0 + sx.x - sy.y - sz.z, xy, zx, turn.x),
                  vec4(xy, 1.0 - sx.x + sy.y - sz.z, yz, turn.y),
                  vec4(zx, yz, 1.0 - sx.x - sy.y + sz.z, turn.z),
                  vec4(turn, 1.0 + sx.x + sy.y + sz.z));
    for (uint i = 0u; i < kSquarings; ++i) {
        m = m * m;
        m *= 1.0 / (m[0].x + m[1].y + m[2].z + m[3].w);
    }
    // All columns are multiples of it; the largest has the most digits.
    vec4 q = m[3];
    float most = m[3].w;
    q = m[0].x > most ? m[0] : q;
    most = max(most, m[0].x);
    q = m[1].y > most ? m[1] : q;
    most = max(most, m[1].y);
    q = m[2].z > most ? m[2] : q;
    return normalize(q);
}
