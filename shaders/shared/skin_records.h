// Records of the model's own colours on the skin, std430.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

// A corner: where it lies on the picture (v runs upwards), and its tint in linear light as halves.
struct SkinCorner {
    float u;
    float v;
    uint red_green;
    uint blue_own;  // own: 1 for a colour of the model, 0 for that of the look
};

// A triangle of skin.
struct SkinRecord {
    uint triangle;  // among those of the body
    SkinCorner first;
    SkinCorner second;
    SkinCorner third;
};

SHARED_END
