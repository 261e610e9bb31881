// The solver's buffers, pulled by gl_VertexID: three consecutive ids are one triangle.
#include "render_bindings.h"
layout(std430, binding = kBindPositions) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kBindTriangles) readonly buffer Triangles { uvec4 triangles[]; };
