// Coordinates that the looks of bodies are made in.
#include "noise.glsl"

uniform vec3 restCenter;
uniform vec3 restExtent;  // half sides of the rest bounds [m]

// Offset from the middle of the uncut body, its longest half side being 1.
vec3 inUnits(vec3 rest) {
    return (rest - restCenter) / max(restExtent.x, max(restExtent.y, restExtent.z));
}
