// Where the renderer's shaders find their buffers and textures.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

SHARED_CONST int kBindPositions = 0;
SHARED_CONST int kBindRestPositions = 1;
SHARED_CONST int kBindTriangles = 2;
SHARED_CONST int kBindIncidenceRanges = 3;
SHARED_CONST int kBindIncidence = 4;
SHARED_CONST int kBindNormals = 5;  // vec4 per vertex and kind: 2 * vertex + kind
SHARED_CONST int kBindCutSkinNormals = 6;
SHARED_CONST int kBindSegments = 6;      // vec4 pairs: ends of lines, or blade poses A, B
SHARED_CONST int kBindLooks = 7;         // two vec4 per piece, see piece_looks.glsl
SHARED_CONST int kBindConstraints = 8;   // what an overlay draws: records of the solver, vertices
SHARED_CONST int kBindContactState = 9;  // ContactState
SHARED_CONST int kBindField = 10;        // see field.glsl
SHARED_CONST int kBindSkin = 12;         // SkinRecord per drawn triangle of skin
SHARED_CONST int kBindSkinCorners = 13;  // see skin_corners.glsl

SHARED_CONST int kUnitShadow = 0;
SHARED_CONST int kUnitGround = 1;
SHARED_CONST int kUnitDepthField = 2;
SHARED_CONST int kUnitEnvironment = 3;
SHARED_CONST int kUnitSkin = 4;  // the picture of the model's own skin

SHARED_CONST float kNoField = -1e30f;  // where a quantity has no value

SHARED_CONST uint kNormalsGroupSize = 64u;

SHARED_END
