// Copied before anything branches, as those of the solver (sim/obstacle.glsl).
#include "body_records.h"
#include "box_records.h"

layout(std430, binding = kBoxUniformsBinding) readonly buffer Uniforms {
    BoxUniforms storedObstacle;
};
BoxUniforms obstacle = storedObstacle;
