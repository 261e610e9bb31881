#pragma once
// The plane across which a triangle and a box are farthest apart, in the coordinates of the box: a
// face of the box, the triangle, or across an edge of each.
struct Plane {
    vec3 normal;  // from the box to the triangle
    float gap;    // [m]
};

Plane wider(Plane a, Plane b) {
    if (b.gap > a.gap) return b;
    return a;
}

Plane across(vec3 axis, vec3 p[3], vec3 reach) {
    vec3 at = vec3(dot(axis, p[0]), dot(axis, p[1]), dot(axis, p[2]));
    float low = min(at.x, min(at.y, at.z));
    float high = max(at.x, max(at.y, at.z));
    float side = low > -high ? 1.0 : -1.0;
    return Plane(side * axis, max(low, -high) - dot(abs(axis), reach));
}

Plane facePlane(vec3 p[3], vec3 reach) {
    Plane best = across(vec3(1.0, 0.0, 0.0), p, reach);
    best = wider(best, across(vec3(0.0, 1.0, 0.0), p, reach));
    return wider(best, across(vec3(0.0, 0.0, 1.0), p, reach));
}

// None along an axis of no length.
Plane acrossLong(Plane best, vec3 axis, float least, vec3 p[3], vec3 reach) {
    float size = length(axis);
    if (!(size > least)) return best;
    return wider(best, across(axis / size, p, reach));
}

Plane widestPlane(Plane face, vec3 p[3], vec3 reach) {
    Plane best = acrossLong(face, cross(p[1] - p[0], p[2] - p[0]), 0.0, p, reach);
    for (int i = 0; i < 3; ++i) {
        vec3 edge = p[(i + 1) % 3] - p[i];
        float least = 1e-3 * length(edge);
        best = acrossLong(best, vec3(0.0, edge.z, -edge.y), least, p, reach);
        best = acrossLong(best, vec3(-edge.z, 0.0, edge.x), least, p, reach);
        best = acrossLong(best, vec3(edge.y, -edge.x, 0.0), least, p, reach);
    }
    return best;
}
