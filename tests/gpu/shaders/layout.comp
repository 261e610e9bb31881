// Declares one storage block per shared record, so that a test can ask the driver for its layout.
#include "constraints.h"

layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Edges { EdgeConstraint edges[]; };
layout(std430, binding = 1) buffer Bends { BendConstraint bends[]; };
layout(std430, binding = 2) buffer Ispcs { IspcConstraint ispcs[]; };

void main() {
    edges[0].a += bends[0].v0 + ispcs[0].vertex;
}
