// The body: its skin, or with WALLS the walls of a cut. Two programs rather than a branch, since
// llvmpipe walks through both sides of every branch.
#include "edge_lines.glsl"
#include "light.glsl"
#include "shadow.glsl"
#include "tone.glsl"
#ifdef WALLS
#include "inner.glsl"
#else
#include "skin_colour.glsl"
#endif

in vec3 worldPosition;
in vec3 worldNormal;
in vec3 restPosition;
in vec3 corners;
flat in vec4 pieceTint;  // w: strength

#ifndef WALLS
flat in vec3 rims;
uniform float cutLines;      // strength
uniform float cutLineWidth;  // [px]
#endif

uniform vec3 eye;
uniform float bodySize;     // diagonal at rest [m]
uniform float floorHeight;
uniform float hasFloor;
uniform float wireframe;
out vec4 color;

struct Look {
    vec3 albedo;
    float wrap;       // how far light creeps past the terminator
    float gloss;
    float roughness;
    float rim;
    float fill;       // light from the side of the viewer: cut faces read at once from anywhere
};

#ifdef WALLS
Look lookOf(vec3 rest) { return Look(innerAlbedo(rest), 0.30, 0.025, 0.42, 0.2, 0.62); }
#else
Look lookOf(vec3 rest) { return Look(skinColour(rest), 0.18, 0.045, 0.36, 1.0, 0.16); }
#endif

// GGX lobe with the visibility term folded into a constant.
float highlight(vec3 n, vec3 v, float roughness) {
    vec3 h = normalize(v + keyDirection);
    float a = roughness * roughness;
    float nh = clamp(dot(n, h), 0.0, 1.0);
    float d = nh * nh * (a * a - 1.0) + 1.0;
    return a * a / (3.14159 * d * d);
}

// Downward faces near the floor see little of the sky.
float openness(vec3 n) {
    if (hasFloor == 0.0) {
        return 1.0;
    }
    float height = max(worldPosition.y - floorHeight, 0.0) / (0.16 * bodySize);
    float down = 0.5 - 0.5 * n.y;
    return 1.0 - 0.8 * down * exp(-height);
}

vec3 shade(Look look, vec3 n, vec3 v) {
    float nl = dot(n, keyDirection);
    float nv = clamp(dot(n, v), 0.0, 1.0);
    float lit = keyVisibility(worldPosition, n);
    float direct = max(nl, 0.0);
    // What creeps past the terminator was scattered inside: no sharp shadow cuts it.
    float scattered = max((nl + look.wrap) / (1.0 + look.wrap), 0.0) - direct;
    float open = openness(n);
    vec3 light = look.albedo * kKeyColor * (direct * lit + 0.4 * scattered);
    float fill = look.fill * nv * (1.0 - 0.7 * direct * lit);
    light += look.albedo * (ambientLight(n) + fill * kFillColor) * open;
    float fresnel = pow(1.0 - nv, 4.0);
    float spec = highlight(n, v, look.roughness) * direct * lit;
    light += kKeyColor * look.gloss * spec;
    vec3 reflected = reflect(-v, n);
    vec3 sky = mix(kGroundColor * 0.5, kSkyColor, smoothstep(-0.5, 0.8, reflected.y));
    light += sky * open * (0.03 + 0.62 * look.rim * fresnel);
    return light;
}

void main() {
    vec3 v = normalize(eye - worldPosition);
    vec3 n = normalize(worldNormal);
    n = gl_FrontFacing ? n : -n;
    Look look = lookOf(restPosition);
    look.albedo = mix(look.albedo, pieceTint.rgb, max(pieceTint.w, 0.0));
    vec3 light = shade(look, n, v);
    if (wireframe > 0.0) {
        float cover = lineCover(edgeDistances(corners), 0.3, 1.2);
        light = mix(light, vec3(0.004, 0.005, 0.007), 0.6 * cover);
    }
#ifndef WALLS
    // A closed cut would not show otherwise.
    vec3 toRim = edgeDistances(corners) + 1e3 * (1.0 - rims);
    light *= 1.0 - cutLines * lineCover(toRim, 0.5 * cutLineWidth, 0.5 * cutLineWidth + 1.0);
#endif
    color = vec4(display(light), 1);
}
