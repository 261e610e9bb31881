#include "app/tools/guillotine.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace kerf::app {
namespace {

constexpr double kMargin = 0.15;    // of the diagonal, beyond the body on all sides
constexpr double kShortest = 1e-3;  // of what a handle is pulled to, of the length before

}  // namespace

Guillotine::Guillotine(const Bounds& bounds) {
    const double margin = kMargin * bounds.diagonal();
    const Vec3 size = bounds.high - bounds.low;
    center_ = bounds.center();
    center_.y() = bounds.high.y() + margin;
    // Across the shorter of the two sides, so that a long body is parted.
    along_ = size.x() <= size.z() ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ());
    halfLength_ = 0.5 * std::min(size.x(), size.z()) + margin;
    drop_ = size.y() + 2 * margin;
}

Blade Guillotine::at(double lowered) const {
    const Vec3 now = center_ + lowered * drop_ * down_;
    return {now - halfLength_ * along_, now + halfLength_ * along_};
}

std::array<Vec3, Guillotine::kHandles> Guillotine::handles() const {
    return {center_, center_ - halfLength_ * along_, center_ + halfLength_ * along_,
            center_ + drop_ * down_};
}

void Guillotine::move(Handle handle, const Vec3& to) {
    const Vec3 arm = to - center_;
    switch (handle) {
        case middle:
            center_ = to;
            return;
        case endA:
            turnTo(-arm);
            return;
        case endB:
            turnTo(arm);
            return;
        case bottom: {
            const Vec3 square = arm - arm.dot(along_) * along_;
            if (square.norm() > kShortest * drop_) {
                down_ = square.normalized();
                drop_ = square.norm();
            }
            return;
        }
    }
}

Eigen::Matrix3d Guillotine::axes() const {
    Eigen::Matrix3d axes;
    axes << along_, -down_, along_.cross(-down_);
    return axes;
}

Guillotine Guillotine::moved(const Vec3& by, const Eigen::Matrix3d& turn) const {
    Guillotine moved = *this;
    moved.center_ += by;
    moved.along_ = (turn * along_).normalized();
    moved.down_ = (turn * down_).normalized();
    return moved;
}

void Guillotine::turnTo(const Vec3& along) {
    const Vec3 unit = along.normalized();
    const Vec3 square = down_ - down_.dot(unit) * unit;
    if (along.norm() > kShortest * halfLength_ && square.norm() > kShortest) {
        along_ = unit;
        halfLength_ = along.norm();
        down_ = square.normalized();
    }
}

}  // namespace kerf::app
