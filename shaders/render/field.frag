// The body in the colours of a quantity, as displays take them: no light, shadow or tone curve
// comes between them and the legend. Its vertices come from surface.vert.
#include "edge_lines.glsl"
#include "field_colors.glsl"

in vec3 worldPosition;
in vec3 worldNormal;
in vec3 restPosition;
in vec3 corners;
in float fieldPlace;
flat in vec4 pieceTint;  // w: strength

uniform vec3 eye;
uniform float wireframe;
out vec4 color;

void main() {
    vec3 v = normalize(eye - worldPosition);
    vec3 shown = fieldShade(fieldPlace, abs(dot(normalize(worldNormal), v)));
    shown = mix(shown, vec3(1), 0.5 * max(pieceTint.w, 0.0));
    shown *= 1.0 - wireframe * 0.45 * lineCover(edgeDistances(corners), 0.3, 1.2);
    color = vec4(shown, 1);
}
