#pragma once

#include <initializer_list>

#include "sim/base/math.h"

namespace kerf {

/// The box of points or boxes: of the items themselves, or of what `place` gives for each [m].
template <class Items = std::initializer_list<Vec3>, class Place = std::identity>
Bounds boxOf(const Items& items, Place place = {}) {
    Bounds box;
    for (const auto& item : items) {
        box.add(std::invoke(place, item));
    }
    return box;
}

/// The box with every side moved outwards.
inline Bounds widened(Bounds box, double margin) {
    box.widen(margin);
    return box;
}

}  // namespace kerf
