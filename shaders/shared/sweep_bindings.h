// Bindings of the kernel that sweeps a body by one group. Storage of X, velocities and d has the
// numbers of the other solver kernels; so have the images of them.
#pragma once
#include "bindings.h"
#include "shared_types.h"
SHARED_BEGIN

// Vertices that fit: their displacements fill the 32 KiB of shared memory that every driver has.
SHARED_CONST uint kSharedSweepVertices = 2048u;

// Storage and, on llvmpipe, images, beside kUniformsBinding and those of X, velocities and d.
SHARED_CONST uint kSweepCorrectionsBinding = 4u;  // as kCorrectionsBinding
SHARED_CONST uint kSweptBinding = 7u;             // vec4: d after the sweep before

// Texture unit: none of those above; constraints follow it.
SHARED_CONST uint kSweepLinksUnit = 16u;

SHARED_END
