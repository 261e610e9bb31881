// From linear light to display bytes.

// A soft shoulder per channel: highlights turn pale instead of clipping.
vec3 toneMap(vec3 c) {
    return clamp((c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}

// The sRGB curve with its power replaced by roots, a third of the cost on llvmpipe and within
// 0.25 of 255 (Taylor, "sRGB approximations for HLSL").
vec3 encodeSrgb(vec3 c) {
    vec3 root2 = sqrt(c);
    vec3 root4 = sqrt(root2);
    vec3 high = 0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * sqrt(root4) -
                0.0225411470 * c;
    return mix(high, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

// Interleaved gradient noise of less than one step hides banding in the dark gradients.
vec3 dither(vec3 c) {
    float n = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return c + (n - 0.5) / 255.0;
}

vec3 display(vec3 linear) { return dither(encodeSrgb(toneMap(linear))); }
