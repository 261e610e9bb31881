// Declares one storage block per shared record, so that a test can ask the driver for its layout.
#include "body_records.h"
#include "constraints.h"
#include "solver_uniforms.h"

layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Spokes { Spoke spokes[]; };
layout(std430, binding = 1) buffer Bends { BendRecord bends[]; };
layout(std430, binding = 2) buffer Ispcs { IspcConstraint ispcs[]; };
layout(std430, binding = 3) buffer Links { VertexLinks links[]; };
layout(std430, binding = 4) buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = 5) buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = 6) buffer VolumeSums { VolumeSum volumeSums[]; };
layout(std430, binding = 7) buffer Measures { BlockMeasure measures[]; };
layout(std430, binding = 8) buffer Uniforms { SolverUniforms uniforms[]; };

// Each block must be used, or the compiler drops it.
void main() {
    spokes[1] = spokes[0];
    bends[1] = bends[0];
    ispcs[1] = ispcs[0];
    links[1] = links[0];
    pieces[1] = pieces[0];
    blocks[1] = blocks[0];
    volumeSums[1] = volumeSums[0];
    measures[1] = measures[0];
    uniforms[1] = uniforms[0];
}
