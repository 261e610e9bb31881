// What patches.comp does to the way and the residual of a vertex before it answers.
STATE_TEXELS(kDirectionBinding) directions;
STATE_TEXELS(kImageBinding) images;
STATE_TEXELS(kResidualBinding) residuals;
STATE_TEXELS(kWayBinding) ways;
STATE_TEXELS(kPressureBinding) pressures;
STATE_TEXELS(kPressureImageBinding) pressureImages;
layout(std430, binding = kResidualBinding) writeonly buffer Residuals { vec4 newResiduals[]; };
layout(std430, binding = kWayBinding) writeonly buffer Ways { vec4 newWays[]; };

#ifdef OF_START
#include "sim/implicit/start.glsl"
Start start;
void prepare(uint piece) { start = startOf(piece); }

vec3 residualOf(uint v) {
    vec3 pressure = fetch(pressures, v).xyz;
    vec3 pressureImage = fetch(pressureImages, v).xyz;
    vec3 direction = fetch(directions, v).xyz + start.swelling * pressure;
    vec3 image = fetch(images, v).xyz + start.swelling * pressureImage;
    vec3 residual = fetch(residuals, v).xyz - start.missing * pressureImage - start.alpha * image -
        start.pressure * fetch(gradients, v).xyz;
    newWays[v] = vec4(start.missing * pressure + start.alpha * direction, 0.0);
    newResiduals[v] = vec4(residual, 0.0);
    return residual;
}
#else
Reach reach;
void prepare(uint piece) { reach = reachOf(pieceAt(piece), numbers.x); }

vec3 residualOf(uint v) {
    vec3 residual = fetch(residuals, v).xyz - reach.alpha * fetch(images, v).xyz -
        reach.pressure * fetch(gradients, v).xyz;
    newWays[v] = vec4(fetch(ways, v).xyz + reach.alpha * fetch(directions, v).xyz, 0.0);
    newResiduals[v] = vec4(residual, 0.0);
    return residual;
}
#endif
