// Declares a storage block of RECORD, one of the shared records, so that a test can ask the driver
// for its layout.
#include "blade_records.h"
#include "body_records.h"
#include "box_records.h"
#include "constraints.h"
#include "contact_records.h"
#include "edge_records.h"
#include "implicit_records.h"
#include "skin_records.h"
#include "solver_uniforms.h"
#include "unfold_records.h"

layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Records { RECORD records[]; };

// The block must be used, or the compiler drops it.
void main() {
    records[1] = records[0];
}
