// How coarse skin is drawn round.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

// How far a triangle bulges towards the planes of its corners, 0 to 1.
SHARED_CONST float kRoundness = 0.75f;

// Where the normals of two ends agree less, what joins them is no edge of the skin but one through
// the body.
SHARED_CONST float kLeastAgreement = 0.3f;

SHARED_END
