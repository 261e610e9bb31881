// Storage bindings of the contact kernels, which are dispatched on their own.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

SHARED_CONST uint kContactUniformsBinding = 0u;      // ContactUniforms
SHARED_CONST uint kContactPositionsBinding = 1u;     // vec4: X [m], w inverse unit mass
SHARED_CONST uint kContactVelocitiesBinding = 2u;    // vec4 [m/s]
SHARED_CONST uint kContactRestBinding = 3u;          // vec4: rest position [m]
SHARED_CONST uint kContactDisplacementBinding = 3u;  // vec4: d [m]
SHARED_CONST uint kContactLinksBinding = 4u;         // VertexLinks
SHARED_CONST uint kContactTrianglesBinding = 5u;     // uvec4, see BodyView
SHARED_CONST uint kContactNormalsBinding = 6u;       // two vec4 per vertex, see normals.glsl
SHARED_CONST uint kContactRestNormalsBinding = 7u;   // the same of the rest shape;
                                                     // w: the wall behind it at rest [m]
SHARED_CONST uint kContactBoxesBinding = 8u;         // two uvec4 per triangle, see tree.glsl
SHARED_CONST uint kContactRecordsBinding = 8u;       // ContactRecord per listed point, then as many
                                                     // for the edges at them
SHARED_CONST uint kContactEdgePairsBinding = 2u;     // EdgePair, kEdgePairsPerPoint a point
SHARED_CONST uint kContactNodesBinding = 9u;         // four uvec4 per node, see tree.glsl
SHARED_CONST uint kContactSumsBinding = 10u;  // kContactSumWords int per vertex: answers.glsl
SHARED_CONST uint kContactSumWords = 9u;
SHARED_CONST uint kContactRangesBinding = 12u;      // IncidenceRange per vertex: of
SHARED_CONST uint kContactIncidenceBinding = 13u;   // 4 * triangle + corner
SHARED_CONST uint kContactCandidatesBinding = 13u;  // ContactCandidate, kCandidatesPerPoint a point
SHARED_CONST uint kContactPointsBinding = 14u;      // uint: points with candidates
// ContactState; behind it a uint per vertex: what contacts take of it
SHARED_CONST uint kContactStateBinding = 15u;
SHARED_CONST uint kContactPiecesBinding = 11u;       // PieceRecord
SHARED_CONST uint kContactColumnsBinding = 4u;       // IspcConstraint
SHARED_CONST uint kContactColumnRangesBinding = 6u;  // IncidenceRange per vertex: of its
SHARED_CONST uint kContactColumnSharesBinding = 7u;  // ConstraintShare
SHARED_CONST uint kContactGroupLeavesUnit = 0u;  // image: node and range of the leaves of a group
SHARED_CONST uint kContactOrderBinding = 10u;    // uint: triangles or vertices, neighbours together

// Texture and image units of what the answers of a substep fetch (answers.glsl), formats as above.
SHARED_CONST uint kContactNormalsUnit = 10u;
SHARED_CONST uint kContactTrianglesUnit = 11u;
SHARED_CONST uint kContactCandidatesUnit = 12u;
SHARED_CONST uint kContactPointsUnit = 13u;
SHARED_CONST uint kContactEdgePairsUnit = 14u;

// Of the kernels of the paper's contact, besides those of the grid.
SHARED_CONST uint kPaperRequestsBinding = 3u;   // PaperRequest per triangle
SHARED_CONST uint kPaperPiecesBinding = 4u;     // PieceBounds per piece
SHARED_CONST uint kPaperRangesBinding = 6u;     // as kContactRangesBinding
SHARED_CONST uint kPaperIncidenceBinding = 7u;  // as kContactIncidenceBinding

SHARED_END
