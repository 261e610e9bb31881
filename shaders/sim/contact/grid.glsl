// A hierarchical hash grid (Eitz and Lixu, Hierarchical Spatial Hashing, 2007): each triangle
// stands in the one cell that holds the centre of its box, of the finest size that is not smaller
// than the box. So the table has one entry a triangle, however they differ in size.
// The includer declares `uniforms`.
float cellSize(uint level) {
    return uniforms.cell * float(1u << level);
}

uint levelOf(float extent) {
    uint level = 0u;
    while (level + 1u < kGridLevels && cellSize(level) < extent) {
        ++level;
    }
    return level;
}

uint bucketOf(ivec3 cell, uint level) {
    uint key = uint(cell.x) * 73856093u ^ uint(cell.y) * 19349663u ^ uint(cell.z) * 83492791u ^
        level * 2654435761u;
    key ^= key >> 15;
    key *= 2246822519u;
    key ^= key >> 13;
    return key & (uniforms.bucket_count - 1u);
}
