// Storage bindings of the simulation kernels. Every number below 16 (what drivers guarantee a
// compute shader in practice); buffers of one role share a binding, since no kernel needs two.
// The same numbers are the texture units of buffers that a kernel fetches as texels.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

SHARED_CONST uint kUniformsBinding = 0u;      // one: SolverUniforms, what all kernels share
SHARED_CONST uint kPositionsBinding = 1u;     // per vertex: base position X [m], inverse unit mass
SHARED_CONST uint kVelocitiesBinding = 2u;    // per vertex: velocity [m/s]
SHARED_CONST uint kDisplacementBinding = 3u;  // per vertex: d = P - X of this step [m]
SHARED_CONST uint kLinksBinding = 4u;  // per vertex: VertexLinks, numbers of constraints, piece
SHARED_CONST uint kConstraintsBinding = 5u;  // per constraint of one type: its record
SHARED_CONST uint kRangesBinding = 6u;       // per vertex: where its entries begin, how many
SHARED_CONST uint kEntriesBinding = 7u;      // per neighbour or constraint of a vertex: which
SHARED_CONST uint kCorrectionsBinding = 8u;  // per constraint, one or two: its pull
SHARED_CONST uint kPlacesBinding = 9u;       // per place on a page: vertex, kNoVertex for holes
SHARED_CONST uint kGradientsBinding = 10u;   // per vertex: gradient of volume dV/dp [m^2]
SHARED_CONST uint kPiecesBinding = 11u;      // per piece: PieceRecord
SHARED_CONST uint kBlocksBinding = 12u;      // per block of pages: BlockRecord
SHARED_CONST uint kBlockSumsBinding = 13u;   // per block: its volume [m^3] or BlockMeasure
SHARED_CONST uint kPagesBinding = 14u;       // per page: its number, block after block
SHARED_CONST uint kAreasBinding = 15u;       // per vertex: rest area [m^2]
SHARED_CONST uint kPreviousBinding = 8u;     // per vertex: d before a sweep over the edges [m]
SHARED_CONST uint kPullsBinding = 5u;        // per pulled vertex: PullRecord
SHARED_CONST uint kSavedBinding = 5u;        // per vertex: position to go back to [m]
SHARED_CONST uint kMarksBinding = 6u;        // per piece: not 0 where it goes back
SHARED_CONST uint kWritesBinding = 0u;       // per word that is written: WordWrite
SHARED_CONST uint kWrittenBinding = 1u;      // any: the buffer that words are written to
SHARED_CONST uint kContactCountsOfStepBinding = 5u;  // one: ContactState
SHARED_CONST uint kSearchedBinding = 8u;  // per vertex: X at the last search for contacts [m]
SHARED_CONST uint kNearbyBinding = 15u;   // per vertex near the blade: NearbyVertex, NearbyQuery
// Texture and image units of a kernel that reads all types of constraints: these + 3 * type.
SHARED_CONST uint kAllRecordsUnit = 20u;  // per constraint: its record
SHARED_CONST uint kAllRangesUnit = 21u;   // per vertex: where its entries begin, how many
SHARED_CONST uint kAllEntriesUnit = 22u;  // per constraint of a vertex: which
// Texture unit of how far the skin at each vertex is folded: see implicit/meet.comp. No kernel has
// another use for it; edges have no records.
SHARED_CONST uint kFoldsUnit = kAllRecordsUnit;

SHARED_END
