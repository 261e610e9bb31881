// From a place in the range of a quantity, 0 to 1, to what displays take.
uniform vec3 colorStops[11];
const vec3 kNoValue = vec3(0.55);

vec3 fieldColor(float place) {
    if (!(place >= -1e3)) {
        return kNoValue;
    }
    float at = clamp(place, 0.0, 1.0) * 10.0;
    int stop = min(int(at), 9);
    return mix(colorStops[stop], colorStops[stop + 1], at - float(stop));
}

// Shaded just so much that the form is seen: what faces the eye has the colour of the legend.
vec3 fieldShade(float place, float facing) {
    return fieldColor(place) * mix(0.62, 1.0, clamp(facing, 0.0, 1.0));
}
