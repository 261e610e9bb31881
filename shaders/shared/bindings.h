// Storage bindings of the simulation kernels. Every number below 16 (what drivers guarantee a
// compute shader in practice); buffers of one role share a binding, since no kernel needs two.
// The same numbers are the texture units of buffers that a kernel fetches as texels.
#ifndef KERF_BINDINGS_H
#define KERF_BINDINGS_H
#include "shared_types.h"
SHARED_BEGIN

SHARED_CONST uint kUniformsBinding = 0u;    // SolverUniforms
SHARED_CONST uint kPositionsBinding = 1u;   // vec4: base position X [m], w inverse unit mass
SHARED_CONST uint kVelocitiesBinding = 2u;  // vec4: [m/s]
SHARED_CONST uint kDisplacementBinding =
    3u;                                      // vec4: d = P - X of this substep [m]; mass_split.glsl
SHARED_CONST uint kLinksBinding = 4u;        // VertexLinks
SHARED_CONST uint kConstraintsBinding = 5u;  // texels of BendRecord or IspcConstraint
SHARED_CONST uint kRangesBinding = 6u;       // IncidenceRange or BendRange per vertex: of
SHARED_CONST uint kEntriesBinding = 7u;  // neighbours, Spoke, bends (see BendRange) or IspcShare
SHARED_CONST uint kCorrectionsBinding = 8u;  // vec4: two per bend, or one per ISPC (bend.comp)
SHARED_CONST uint kPlacesBinding = 9u;       // uint: vertices by pages, kNoVertex for holes
SHARED_CONST uint kGradientsBinding = 10u;   // vec4 per vertex: dV/dp [m^2]
SHARED_CONST uint kPiecesBinding = 11u;      // PieceRecord
SHARED_CONST uint kBlocksBinding = 12u;      // BlockRecord
SHARED_CONST uint kBlockSumsBinding = 13u;   // VolumeSum or BlockMeasure, one per block
SHARED_CONST uint kPagesBinding = 14u;       // uint: the pages of each block, block after block
SHARED_CONST uint kAreasBinding = 15u;       // float: rest area of each vertex [m^2]
SHARED_CONST uint kImpulsesBinding = 8u;     // VolumeImpulse per piece
SHARED_CONST uint kPreviousBinding = 8u;     // vec4: d before a sweep over the edges [m]
SHARED_CONST uint kPullsBinding = 5u;        // PullRecord
SHARED_CONST uint kSavedBinding = 5u;        // vec4: positions to go back to [m]
SHARED_CONST uint kMarksBinding = 6u;        // uint per piece: not 0 where it goes back
SHARED_CONST uint kWritesBinding = 0u;       // WordWrite, for a kernel of its own
SHARED_CONST uint kWrittenBinding = 1u;      // what it writes to
SHARED_CONST uint kContactCountsOfStepBinding = 5u;  // ContactState
SHARED_CONST uint kSearchedBinding = 8u;             // vec4: X at the last search for contacts [m]
SHARED_CONST uint kNearbyBinding = 15u;              // NearbyQuery and its NearbyVertex records
// Texture unit of how far the skin at each vertex is folded: see folds.glsl. No kernel has another
// use for it.
SHARED_CONST uint kFoldsUnit = 28u;
// Texture units of a kernel that reads all constraints besides the triangles around each vertex.
SHARED_CONST uint kBendsBinding = 5u;        // texels of BendRecord
SHARED_CONST uint kIspcsBinding = 8u;        // texels of IspcConstraint
SHARED_CONST uint kEdgeRangesBinding = 12u;  // IncidenceRange per vertex: of
SHARED_CONST uint kSpokesBinding = 13u;      // Spoke

SHARED_END
#endif
