// Lines along the edges of a triangle, from barycentric coordinates.

// How far it is to the three edges [px].
vec3 edgeDistances(vec3 corners) {
    vec3 slope = sqrt(dFdx(corners) * dFdx(corners) + dFdy(corners) * dFdy(corners));
    return corners / max(slope, vec3(1e-6));
}

// Of a line along edges, from its middle to where it ends [px].
float lineCover(vec3 d, float inner, float outer) {
    return 1.0 - smoothstep(inner, outer, min(d.x, min(d.y, d.z)));
}
