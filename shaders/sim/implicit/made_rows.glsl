// What kernels find of what vertices meet in a step, as rows of contact. The includer declares
// `rows`.
#include "sim/implicit/uniforms.glsl"
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
STATE_TEXELS(kKeptSlipsUnit) keptSlips;
RECORD_WORDS(kFirmnessUnit) firmness;
layout(std430, binding = kLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kMadeRowVerticesBinding) writeonly buffer Vertices { uvec4 vertices[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 displacementOf(uint v) { return implicit.step * fetch(velocities, v); }

// Of one that is held, as if it had no mass.
float firmnessOf(uint v) {
    float inverse = fetch(positions, v).w;
    float mass = inverse > 0.0 ? massOf(inverse) : 0.0;
    return uintBitsToFloat(fetch(firmness, v).x) + implicit.contact.stiffness * mass;
}

// Of what meets by these weights.
float firmnessOf(uvec3 v, vec3 weights) {
    return weights.x * firmnessOf(v.x) + weights.y * firmnessOf(v.y) +
        weights.z * firmnessOf(v.z);
}

// Of two that yield to each other, as far as both do alike.
float together(float a, float b) { return 2.0 * a * b / (a + b); }

// What a row says besides its vertices; `weights`: see ContactRow.
struct Met {
    vec3 normal;
    float gap;
    float stiffness;
    vec4 weights;
    vec3 lead;
    bool slides;   // without friction
    float letOut;  // of a depth that no push has made, in the step
};

// What the step before has left: of what slides, its normal instead of a slip, by which it is known
// again where other edges may have come nearer. See end.comp.
struct Kept {
    vec3 slip;
    float push;
};

Kept keptOf(uint row, Met met) {
    vec4 kept = fetch(keptSlips, row);
    float along = dot(kept.xyz, met.normal);
    if (met.slides) return Kept(vec3(0.0), along > kSameNormal ? kept.w : 0.0);
    return Kept(kept.xyz - along * met.normal, kept.w);
}

void setRow(uint row, Met met) {
    Kept kept = keptOf(row, met);
    // What was not pressed in has come otherwise, and is let out little by little.
    float letOut = min(met.letOut * max(-met.gap, 0.0), implicit.contact.let_out);
    float pressed = kept.push / met.stiffness + letOut;
    rows[kRowTexels * row] = vec4(met.normal, max(met.gap, -pressed));
    rows[kRowTexels * row + 1u] = vec4(kept.slip, met.stiffness);
    rows[kRowTexels * row + 2u] = met.weights;
    rows[kRowTexels * row + 3u] = vec4(met.lead, met.slides ? kAnyPush : kept.push);
}

void setNone(uint row) { rows[kRowTexels * row + 1u] = vec4(0.0); }
