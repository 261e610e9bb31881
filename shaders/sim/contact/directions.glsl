// Directions in 24 bins, four on each face of a cube, as bits of a word: which of them the normals
// of some triangles point to, and which a vertex could touch. So most triangles around a vertex,
// those of its own surface, are passed over without a look at their corners.
uint binOf(vec3 d) {
    vec3 size = abs(d);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    uint face = 2u * uint(axis) + (d[axis] < 0.0 ? 1u : 0u);
    return 4u * face + (d[(axis + 1) % 3] < 0.0 ? 1u : 0u) + (d[(axis + 2) % 3] < 0.0 ? 2u : 0u);
}

// Every direction of a bin lies within 31.4 degrees of its middle, (1, 0.38, 0.38) on some axes,
// and opposes a normal by kOpposed or more only where that is 95.7 degrees away: so one whose
// middle is nearer than 64.3 degrees never does, and this is above the product of the two then.
const float kMostAlong = 0.4931;

// The bins of the axis along which a normal goes by `along`, those of the next ones by `others`.
uint binsOfAxis(float along, vec2 others, float most) {
    vec4 sums = 0.38 * vec4(others.x + others.y, others.y - others.x, others.x - others.y,
                            -others.x - others.y);
    uvec4 bins = uvec4(lessThan(vec4(along) + sums, vec4(most))) +
        16u * uvec4(lessThan(sums - vec4(along), vec4(most)));
    return bins.x | bins.y << 1 | bins.z << 2 | bins.w << 3;
}

// The bins that may hold a direction opposed to a vertex normal, which is no longer than 1.
uint opposedBins(vec3 normal) {
    float size = length(normal);
    float most = kMostAlong * size;
    uint bins = binsOfAxis(normal.x, normal.yz, most) |
        binsOfAxis(normal.y, normal.zx, most) << 8 | binsOfAxis(normal.z, normal.xy, most) << 16;
    return size > -kOpposed ? bins : 0u;
}
