#include "app/tools/ruler.h"

#include <cmath>
#include <numbers>

namespace kerf::app {
namespace {

constexpr double kStep = std::numbers::pi / 12;

}  // namespace

std::optional<Vec2> Ruler::along(const Vec2& pixel) {
    const Vec2 way = pixel - start_;
    if (!direction_) {
        if (way.norm() < kTell) {
            return std::nullopt;
        }
        const double angle = kStep * std::round(std::atan2(way.y(), way.x()) / kStep);
        direction_ = Vec2(std::cos(angle), std::sin(angle));
    }
    return start_ + direction_->dot(way) * *direction_;
}

}  // namespace kerf::app
