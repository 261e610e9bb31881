// How single pieces are shown; those behind the end of the list look as always.
layout(std430, binding = kBindLooks) readonly buffer Looks { vec4 looks[]; };
uniform uint lookCount;

vec4 lookOfPiece(uvec4 triangle) {
    uint piece = triangle.w >> 8u;
    return piece < lookCount ? looks[piece] : vec4(0);
}
