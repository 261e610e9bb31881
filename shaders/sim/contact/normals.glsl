// The outward normals of a vertex, of its skin and of its walls: the sum of the triangles' area
// vectors over the sum of their lengths, so 1 long where the surface is flat and short at tips and
// at the front of a slit. Two, since at the rim of a cut through a thin plate the skin would
// outweigh the wall; both are the same where there is one kind alone. The includer declares
// triangles and their incidence.
struct VertexNormals {
    vec3 skin;
    vec3 wall;
    uint kinds;  // what its triangles are
};

VertexNormals normalsOf(uint v, samplerBuffer positions) {
    vec3 skin = vec3(0.0);
    vec3 wall = vec3(0.0);
    vec2 areas = vec2(0.0);
    uvec2 range = fetch(ranges, v).xy;
    for (uint k = range.x; k < range.y; ++k) {
        uvec4 t = fetch(triangles, fetch(incidence, k).x >> 2);
        vec3 a = fetch(positions, t.x).xyz;
        vec3 normal = cross(fetch(positions, t.y).xyz - a, fetch(positions, t.z).xyz - a);
        bool isWall = (t.w & 1u) != 0u;
        skin += isWall ? vec3(0.0) : normal;
        wall += isWall ? normal : vec3(0.0);
        areas += length(normal) * (isWall ? vec2(0.0, 1.0) : vec2(1.0, 0.0));
    }
    uint kinds = (areas.x > 0.0 ? kTouchesSkin : 0u) | (areas.y > 0.0 ? kTouchesWall : 0u);
    skin = areas.x > 0.0 ? skin / areas.x : vec3(0.0);
    wall = areas.y > 0.0 ? wall / areas.y : skin;
    return VertexNormals(areas.x > 0.0 ? skin : wall, wall, kinds);
}
