// What patches.comp does to the way and the residual of a vertex before it answers. The residual is
// kept without the forces of contact; totals, which have them, lie where those of the slot before
// the last lay.
STATE_TEXELS(kDirectionBinding) directions;
STATE_TEXELS(kImageBinding) images;
STATE_TEXELS(kResidualBinding) residuals;
STATE_TEXELS(kWayBinding) ways;
STATE_TEXELS(kPressureBinding) pressures;
STATE_TEXELS(kPressureImageBinding) pressureImages;
STATE_TEXELS(kReachesUnit) reaches;
RECORD_QUADS(kContactForcesUnit) contactForces;
layout(std430, binding = kResidualBinding) writeonly buffer Residuals { vec4 newResiduals[]; };
layout(std430, binding = kWayBinding) writeonly buffer Ways { vec4 newWays[]; };
layout(std430, binding = kTotalBinding) writeonly buffer Totals { vec4 newTotals[]; };
layout(std430, binding = kContactForcesBinding) writeonly buffer Forces { ivec4 newForces[]; };

Reach reach;
float forceUnit;
void prepare(uint piece) {
    forceUnit = forceUnitOf(piece);
    vec4 words = fetch(reaches, piece);
    reach = Reach(words.x, words.y, words.z, words.w);
}

// A loop, which llvmpipe skips where none of eight threads has a contact.
vec3 takeContactForce(uint v) {
    ivec4 sum = ivec4(fetch(contactForces, v));
    for (uint once = sum != ivec4(0) ? 1u : 0u; once > 0u; --once) newForces[v] = ivec4(0);
    return forceUnit * vec3(sum.xyz);
}

vec3 residualOf(uint v) {
    vec3 direction = fetch(directions, v).xyz;
    vec3 image = fetch(images, v).xyz;
#ifdef OF_START
    vec3 pressure = fetch(pressures, v).xyz;
    vec3 pressureImage = fetch(pressureImages, v).xyz;
    direction += reach.swelling * pressure;
    image += reach.swelling * pressureImage;
    vec3 way = reach.missing * pressure;
    vec3 residual = fetch(residuals, v).xyz - reach.missing * pressureImage;
#else
    vec3 way = fetch(ways, v).xyz;
    vec3 residual = fetch(residuals, v).xyz;
#endif
    residual -= reach.alpha * image + reach.pressure * fetch(gradients, v).xyz;
    newWays[v] = vec4(way + reach.alpha * direction, 0.0);
    newResiduals[v] = vec4(residual, 0.0);
    vec3 total = residual + takeContactForce(v);
    newTotals[2u * v + (numbers.x & 1u)] = vec4(total, 0.0);
    return total;
}
