#include "sim/contact/obstacles.h"

namespace kerf {

static_assert(sizeof(shared::BoxRecord) == 64);

shared::vec4 packed(const Vec3& v, double w) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
            static_cast<float>(w)};
}

shared::BoxRecord boxRecord(const Vec3& center, const Eigen::Matrix3d& axes, const Vec3& half) {
    return {packed(center, 0), packed(axes.col(0), half.x()), packed(axes.col(1), half.y()),
            packed(axes.col(2), half.z())};
}

}  // namespace kerf
