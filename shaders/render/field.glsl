// Values of a quantity on the surface, at 2 * vertex + kind, and behind them the area at rest that
// has each. A value that is not there is kNoField.
#include "render_bindings.h"
layout(std430, binding = kBindField) FIELD_ACCESS buffer Field { float fieldValues[]; };
