// Bindings of the kernel that solves a whole step of a small body. Storage of X, velocities and d
// has the numbers of the other solver kernels; so have the images of them.
#pragma once
#include "bindings.h"
#include "shared_types.h"
SHARED_BEGIN

// What fits: vertices (their displacements fill the 32 KiB of shared memory that every driver has),
// and blocks and pieces to sum over.
SHARED_CONST uint kSmallBodyVertices = 2048u;
SHARED_CONST uint kSmallBodyBlocks = 64u;

// Storage, beside kUniformsBinding, kPositionsBinding, kVelocitiesBinding and kDisplacementBinding.
SHARED_CONST uint kSmallCorrectionsBinding = 4u;  // as kCorrectionsBinding; images too
SHARED_CONST uint kSmallGradientsBinding = 5u;    // as kGradientsBinding; images too
SHARED_CONST uint kSmallPartsBinding = 6u;        // vec2 per place of each block; images too
SHARED_CONST uint kSmallSweptBinding = 7u;        // vec4: d after the sweep before; images too
SHARED_CONST uint kSmallImpulsesBinding = 8u;
SHARED_CONST uint kSmallPiecesBinding = 9u;
SHARED_CONST uint kSmallObstacleBinding = 10u;  // BoxUniforms
SHARED_CONST uint kSmallTouchesBinding = 11u;   // as kBoxRecordsBinding
SHARED_CONST uint kSmallFoldsBinding = 12u;     // as kUnfoldFoldsBinding
SHARED_CONST uint kSmallContactBinding = 7u;    // ContactUniforms, beside substeps
SHARED_CONST uint kSmallRecordsBinding = 13u;   // as kContactRecordsBinding
SHARED_CONST uint kSmallSumsBinding = 14u;      // as kContactSumsBinding
SHARED_CONST uint kSmallStateBinding = 15u;     // as kContactStateBinding

// Texture units and, on llvmpipe, image units: none of those above, nor of contact_bindings.h;
// constraints follow them.
SHARED_CONST uint kSmallLinksUnit = 16u;
SHARED_CONST uint kSmallNeighbourRangesUnit = 17u;
SHARED_CONST uint kSmallNeighboursUnit = 18u;
SHARED_CONST uint kSmallPlacesUnit = 19u;
SHARED_CONST uint kSmallPullsUnit = 8u;
SHARED_CONST uint kSmallPagesUnit = 15u;
SHARED_CONST uint kSmallBlocksUnit = 29u;
SHARED_CONST uint kSmallBoxesUnit = 30u;        // BoxRecord
SHARED_CONST uint kSmallPieceBoundsUnit = 31u;  // PieceBounds
SHARED_CONST uint kSmallRestUnit = 9u;

SHARED_END
