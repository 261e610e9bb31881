#include "sim/solve/float_vectors.h"

#include <algorithm>

#include "sim/base/boxes.h"

namespace kerf {

std::vector<shared::vec4> packed(const std::vector<Vec3f>& values) {
    std::vector<shared::vec4> out(values.size());
    std::ranges::transform(values, out.begin(), [](const Vec3f& a) { return packed(a, 0.0f); });
    return out;
}

std::vector<Vec3f> unpacked(std::span<const shared::vec4> values) {
    std::vector<Vec3f> out(values.size());
    std::ranges::transform(values, out.begin(),
                           [](const shared::vec4& a) { return Vec3f(a.x, a.y, a.z); });
    return out;
}

Bounds boundsOf(const std::vector<Vec3f>& values) {
    return boxOf(values, [](const Vec3f& u) -> Vec3 { return u.cast<double>(); });
}

}  // namespace kerf
