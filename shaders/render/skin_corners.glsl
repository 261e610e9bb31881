// What normals.comp tells of the corners of the skin. The includer defines SKIN_CORNERS_ACCESS.
layout(std430, binding = kBindSkinCorners) SKIN_CORNERS_ACCESS buffer SkinCorners {
    uvec4 rimCommand;  // of glDrawArraysIndirect: y counts the rims of cuts
    // Of corner 3 * triangle + corner the normal (corner_normals.glsl). Behind those of all
    // triangles: an edge on a rim each, 4 * triangle + the corner that it begins at.
    uint skinCorners[];
};
