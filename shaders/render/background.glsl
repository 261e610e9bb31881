// Blue-grey, dark or bright. Over a floor: haze at the horizon, another tone above. In empty space:
// a soft glow behind the middle of the picture, as a studio backdrop.
uniform float bright;

vec3 sky(float elevation) {
    vec3 haze = mix(vec3(0.032, 0.037, 0.046), vec3(0.74, 0.77, 0.81), bright);
    vec3 zenith = mix(vec3(0.0085, 0.0100, 0.0140), vec3(0.46, 0.53, 0.64), bright);
    return mix(haze, zenith, smoothstep(-0.02, 0.60, elevation));
}

vec3 studio(vec2 screen) {
    vec2 centered = (screen - vec2(0.5, 0.48)) * vec2(1.2, 1.45);
    vec3 low = mix(vec3(0.0150, 0.0175, 0.0235), vec3(0.62, 0.65, 0.70), bright);
    vec3 high = mix(vec3(0.0075, 0.0088, 0.0122), vec3(0.46, 0.50, 0.56), bright);
    vec3 glow = mix(vec3(0.026, 0.031, 0.040), vec3(0.30, 0.30, 0.30), bright);
    return mix(low, high, screen.y) + glow * exp(-3.4 * dot(centered, centered));
}
