// From linear light to display bytes.

// A soft shoulder per channel: highlights turn pale instead of clipping.
vec3 toneMap(vec3 c) {
    return clamp((c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}

vec3 encodeSrgb(vec3 c) {
    vec3 low = 12.92 * c;
    vec3 high = 1.055 * pow(max(c, vec3(1e-5)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThan(c, vec3(0.0031308)));
}

// Interleaved gradient noise of less than one step hides banding in the dark gradients.
vec3 dither(vec3 c) {
    float n = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return c + (n - 0.5) / 255.0;
}

vec3 display(vec3 linear) { return dither(encodeSrgb(toneMap(linear))); }
