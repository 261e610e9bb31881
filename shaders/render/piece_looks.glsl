// How single pieces are shown; those behind the end of the list look as always. Two words each:
// tint and its strength (below 0: hidden), and how far from its place it is drawn.
layout(std430, binding = kBindLooks) readonly buffer Looks { vec4 looks[]; };
uniform uint lookCount;

vec4 lookOfPiece(uvec4 triangle) {
    uint piece = triangle.w >> 8u;
    return piece < lookCount ? looks[2u * piece] : vec4(0);
}

vec3 shiftOfPiece(uvec4 triangle) {
    uint piece = triangle.w >> 8u;
    return piece < lookCount ? looks[2u * piece + 1u].xyz : vec3(0);
}
