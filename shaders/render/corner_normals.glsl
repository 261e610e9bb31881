// A unit vector in one word: folded onto an octahedron, 16 bits a coordinate (Cigolle and others,
// "A survey of efficient representations for independent unit vectors").
uint packedNormal(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return packSnorm2x16(n.z < 0.0 ? (1.0 - abs(p.yx)) * signs : p);
}

vec3 unpackedNormal(uint word) {
    vec2 p = unpackSnorm2x16(word);
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float back = max(-n.z, 0.0);
    n.x += n.x >= 0.0 ? -back : back;
    n.y += n.y >= 0.0 ? -back : back;
    return normalize(n);
}
