// The range of the colours from the largest value: rounded up to a round number, so that it stands
// still while the body moves. One thread; a storage barrier follows.
layout(local_size_x = 1) in;

#define FIELD_ACCESS
#include "field.glsl"

uniform float fixedHigh;  // 0: automatic
uniform float leastHigh;
uniform float hasSign;

// Not below `value`. Powers of ten that are exact are divided by or multiplied with.
float roundedUp(float value) {
    const float kSteps[8] = float[](1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0);
    for (int power = -9; power < 10; ++power) {
        float ten = 1.0;
        for (int i = 0; i < abs(power); ++i) {
            ten *= 10.0;
        }
        for (int i = 0; i < 8; ++i) {
            float step = power < 0 ? kSteps[i] / ten : kSteps[i] * ten;
            if (step >= 0.9999 * value) {
                return step;
            }
        }
    }
    return value;
}

void main() {
    float high = fixedHigh > 0.0 ? fixedHigh : roundedUp(max(uintBitsToFloat(largest), leastHigh));
    rangeHigh = high;
    rangeLow = hasSign > 0.0 ? -high : 0.0;
}
