// The body: its skin, or with WALLS the walls of a cut. Two programs rather than a branch, since
// llvmpipe walks through both sides of every branch.
#include "edge_lines.glsl"
#include "render_bindings.h"  // once, and here: it must not fall to a condition below
#include "tone.glsl"
#ifdef MATCAP
#include "matcap.glsl"
#else
#include "lighting.glsl"
#endif
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

uniform vec3 eye;
uniform float wireframe;
out vec4 color;

#ifdef WALLS
in float torn;
const float kTornContrast = 0.5;  // of its high and low places
const float kFacing = 0.36;
vec3 ownColor(vec3 rest) { return innerAlbedo(rest); }
#else
const float kFacing = 0.06;
vec3 ownColor(vec3 rest) { return skinColour(rest); }
#endif

// A normal as the height of the surface tells it (Mikkelsen, "Bump mapping unparametrized
// surfaces on the GPU"). `height` [m].
vec3 bumped(vec3 n, float height) {
    vec3 dx = dFdx(worldPosition);
    vec3 dy = dFdy(worldPosition);
    vec3 r1 = cross(dy, n);
    vec3 r2 = cross(n, dx);
    float det = dot(dx, r1);
    vec3 slope = sign(det) * (dFdx(height) * r1 + dFdy(height) * r2);
    return normalize(abs(det) * n - slope + 1e-20 * n);
}

void main() {
    vec3 v = normalize(eye - worldPosition);
    vec3 n = normalize(worldNormal);
    n = gl_FrontFacing ? n : -n;
#if defined(BUMPS) && !defined(MATCAP)
    n = bumped(n, heightOf(restPosition));
#endif
    vec3 albedo = mix(ownColor(restPosition), pieceTint.rgb, max(pieceTint.w, 0.0));
#if defined(WALLS) && !defined(MATCAP)
    vec3 u = inUnits(restPosition);
    float rise = torn * tornHeight(u);
    float unit = max(restExtent.x, max(restExtent.y, restExtent.z));
    float seen = clamp(1.2 - 15.0 * length(fwidth(u)), 0.0, 1.0);  // finer than pixels: flat
    vec3 rough = bumped(n, seen * kTornDepth * unit * rise);
    n = torn > 0.0 ? rough : n;  // to the bit what a blade leaves
    albedo *= torn > 0.0 ? 1.0 + kTornContrast * (rise - 0.5 * torn) : 1.0;
#endif
#ifdef MATCAP
    vec3 light = matcap(albedo, n, v);
#else
    vec3 light = shade(worldPosition, albedo, n, v, kFacing);
#endif
    if (wireframe > 0.0) {
        float cover = lineCover(edgeDistances(corners), 0.3, 1.2);
        light = mix(light, vec3(0.004, 0.005, 0.007), 0.6 * cover);
    }
    color = vec4(display(light), 1);
}
