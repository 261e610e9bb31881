// Elements of buffers that a kernel reads through texture units (gpu::Buffer::bindTexels). A buffer's
// unit has the number of its storage binding.

vec4 fetch(samplerBuffer texels, uint index) {
    return texelFetch(texels, int(index));
}

uvec4 fetch(usamplerBuffer texels, uint index) {
    return texelFetch(texels, int(index));
}

#ifdef KERF_BODY_RECORDS_H
Spoke fetchSpoke(usamplerBuffer records, uint index) {
    uvec4 words = fetch(records, index);
    return Spoke(words.x, uintBitsToFloat(words.y), uintBitsToFloat(words.z), words.w);
}
#endif

#ifdef KERF_CONSTRAINTS_H
BendConstraint fetchBend(usamplerBuffer records, uint index) {
    uvec2 edge = fetch(records, 3u * index).xy;
    uvec2 apexes = fetch(records, 3u * index + 1u).xy;
    vec2 rest = uintBitsToFloat(fetch(records, 3u * index + 2u).xy);
    return BendConstraint(edge.x, edge.y, apexes.x, apexes.y, rest.x, rest.y);
}

IspcConstraint fetchIspc(usamplerBuffer records, uint index) {
    uvec4 corners = fetch(records, 2u * index);
    vec4 rest = uintBitsToFloat(fetch(records, 2u * index + 1u));
    return IspcConstraint(corners.x, corners.y, corners.z, corners.w, rest.x, rest.y, rest.z, rest.w);
}
#endif
