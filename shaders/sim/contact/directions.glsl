// Directions in 24 bins, four on each face of a cube, as bits of a word: which of them the normals
// of some triangles point to, and which a vertex could touch. So most triangles around a vertex,
// those of its own surface, are passed over without a look at their corners.
uint binOf(vec3 d) {
    vec3 size = abs(d);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    uint face = 2u * uint(axis) + (d[axis] < 0.0 ? 1u : 0u);
    return 4u * face + (d[(axis + 1) % 3] < 0.0 ? 1u : 0u) + (d[(axis + 2) % 3] < 0.0 ? 2u : 0u);
}

vec3 middleOf(uint bin) {
    int axis = int(bin / 8u);
    vec3 d;
    d[axis] = (bin & 4u) != 0u ? -1.0 : 1.0;
    d[(axis + 1) % 3] = (bin & 1u) != 0u ? -0.38 : 0.38;
    d[(axis + 2) % 3] = (bin & 2u) != 0u ? -0.38 : 0.38;
    return d / sqrt(1.0 + 2.0 * 0.38 * 0.38);
}

// Every direction of a bin lies within this of its middle.
const float kBinCosine = 0.854;
const float kBinSine = 0.5203;

// The bins that hold a direction opposed to a vertex normal, which is no longer than 1.
uint opposedBins(vec3 normal) {
    float size = length(normal);
    uint bins = 0u;
    for (uint bin = 0u; bin < 24u; ++bin) {
        float along = dot(normal, middleOf(bin));
        float across = sqrt(max(size * size - along * along, 0.0));
        // The least that a direction within the cone gives, or -size where the cone holds that.
        bool holdsOpposite = along <= -kBinCosine * size;
        float least = holdsOpposite ? -size : along * kBinCosine - across * kBinSine;
        if (least < kOpposed + 1e-5) bins |= 1u << bin;
    }
    return bins;
}
