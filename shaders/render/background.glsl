// Dark blue-grey. Over a floor: haze at the horizon, darker above. In empty space: a soft glow
// behind the middle of the picture, as a studio backdrop.
vec3 sky(float elevation) {
    const vec3 kHaze = vec3(0.0150, 0.0175, 0.0225);
    const vec3 kZenith = vec3(0.0048, 0.0056, 0.0080);
    return mix(kHaze, kZenith, smoothstep(-0.02, 0.42, elevation));
}

vec3 studio(vec2 screen) {
    vec2 centered = (screen - vec2(0.5, 0.48)) * vec2(1.2, 1.45);
    vec3 base = mix(vec3(0.0150, 0.0175, 0.0235), vec3(0.0075, 0.0088, 0.0122), screen.y);
    return base + vec3(0.026, 0.031, 0.040) * exp(-3.4 * dot(centered, centered));
}
