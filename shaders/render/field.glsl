// Values of a quantity on the surface, at 2 * vertex + kind, and what the colours reach from and
// to. A value that is not there is kNoField.
#include "render_bindings.h"
layout(std430, binding = kBindField) FIELD_ACCESS buffer Field { float fieldValues[]; };
layout(std430, binding = kBindFieldRange) FIELD_ACCESS buffer Range {
    uint largest;  // bits of the largest |value|
    float rangeLow;
    float rangeHigh;
};
