#pragma once
// How the body of the blade moves in a substep.

// Of the point of the blade that is at x [m].
vec3 wayOfBlade(BladeRecord blade, vec3 x) {
    return blade.shift.xyz + cross(blade.turn.xyz, x - blade.box.center.xyz);
}
