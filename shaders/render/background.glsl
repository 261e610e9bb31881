// Blue-grey, dark or bright. Over a floor: haze at the horizon, another tone above. In empty space:
// a soft glow behind the middle of the picture, as a studio backdrop.
uniform float bright;
// Where the lower left corner of the picture looks, and from there to its other corners.
uniform vec3 rayCorner;
uniform vec3 rayAcross;
uniform vec3 rayUp;

// Sine of the angle above the horizon; `screen`: 0 to 1.
float elevation(vec2 screen) {
    return normalize(rayCorner + screen.x * rayAcross + screen.y * rayUp).y;
}

vec3 sky(vec2 screen) {
    vec3 haze = mix(vec3(0.055, 0.066, 0.088), vec3(0.80, 0.82, 0.84), bright);
    vec3 zenith = mix(vec3(0.0060, 0.0075, 0.0120), vec3(0.40, 0.49, 0.63), bright);
    float up = max(elevation(screen), 0.0);
    return mix(zenith, haze, 1.0 / (1.0 + mix(26.0, 9.0, bright) * up * up + 4.0 * up));
}

vec3 studio(vec2 screen) {
    vec2 centered = (screen - vec2(0.5, 0.48)) * vec2(1.2, 1.45);
    vec3 low = mix(vec3(0.0150, 0.0175, 0.0235), vec3(0.62, 0.65, 0.70), bright);
    vec3 high = mix(vec3(0.0075, 0.0088, 0.0122), vec3(0.46, 0.50, 0.56), bright);
    vec3 glow = mix(vec3(0.026, 0.031, 0.040), vec3(0.30, 0.30, 0.30), bright);
    return mix(low, high, screen.y) + glow * exp(-3.4 * dot(centered, centered));
}
