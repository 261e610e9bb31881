// The plane that opens the picture of a body. With GL_CLIP_DISTANCE0 enabled.
uniform vec4 sectionPlane;  // xyz: normal, towards what is hidden; w: - normal . point

void hideBehindSection(vec3 world) {
    gl_ClipDistance[0] = -dot(sectionPlane, vec4(world, 1));
}
