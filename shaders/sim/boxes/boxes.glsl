#pragma once
// A box and its own coordinates, in which it is axis-parallel about the origin.
vec3 halfOf(BoxRecord box) { return vec3(box.x.w, box.y.w, box.z.w); }

vec3 toBox(BoxRecord box, vec3 v) {
    return vec3(dot(box.x.xyz, v), dot(box.y.xyz, v), dot(box.z.xyz, v));
}

vec3 fromBox(BoxRecord box, vec3 v) { return v.x * box.x.xyz + v.y * box.y.xyz + v.z * box.z.xyz; }

// Coulomb friction: what is left of a tangential way where `pressed` was stopped along the normal.
float slipLeft(float way, float pressed, float friction) {
    return way > 0.0 ? 1.0 - min(1.0, friction * pressed / way) : 1.0;
}

// Overlaps up to here are touches, as a share of the depth of touches.
const float kSkinDeep = 0.1;
