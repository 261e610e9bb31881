// Dark blue-grey, lighter towards the lower middle, as a studio backdrop.
vec3 backdrop(vec2 screen, float glow) {
    float rise = smoothstep(-0.1, 1.0, screen.y);
    vec3 top = vec3(0.0060, 0.0072, 0.0100);
    vec3 low = vec3(0.0200, 0.0240, 0.0320);
    vec3 color = mix(low, top, rise);
    vec2 centered = (screen - vec2(0.5, 0.46)) * vec2(1.25, 1.5);
    return color + glow * vec3(0.022, 0.027, 0.036) * exp(-3.2 * dot(centered, centered));
}
