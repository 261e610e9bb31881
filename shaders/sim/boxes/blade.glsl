// How the body of the blade moves in the substep. The includer declares `blades`.
#include "sim/numbers.glsl"

uint substep = numbers.x;

// Of the point of the blade that is at x [m].
vec3 wayOfBlade(BladeRecord blade, vec3 x) {
    return blade.shift.xyz + cross(blade.turn.xyz, x - blade.box.center.xyz);
}
