#include "sim/cut/exact/piercing.h"

#include "sim/base/predicates.h"

namespace kerf::cut {

bool pierces(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    if (orientSign3d(a, b, c, p) * orientSign3d(a, b, c, q) >= 0) {
        return false;
    }
    const int ab = orientSign3d(p, q, a, b);
    return ab != 0 && ab == orientSign3d(p, q, b, c) && ab == orientSign3d(p, q, c, a);
}

}  // namespace kerf::cut
