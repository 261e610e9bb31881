// I^-1 L by Cramer's rule, where I = tr(P) 1 - P, P = sum of m x x^T: its diagonal and its yz, zx,
// xy. w: 0 where there is none.
vec4 spinOf(vec3 angularMomentum, vec3 squares, vec3 mixed) {
    vec3 diagonal = squares.yzx + squares.zxy;
    vec3 first = vec3(diagonal.x, -mixed.z, -mixed.y);
    vec3 second = vec3(-mixed.z, diagonal.y, -mixed.x);
    vec3 third = vec3(-mixed.y, -mixed.x, diagonal.z);
    float determinant = dot(first, cross(second, third));
    float size = diagonal.x + diagonal.y + diagonal.z;
    if (!(determinant > 1e-6 * size * size * size)) return vec4(0.0);
    return vec4(vec3(dot(angularMomentum, cross(second, third)),
                     dot(first, cross(angularMomentum, third)),
                     dot(first, cross(second, angularMomentum))) / determinant, 1.0);
}
