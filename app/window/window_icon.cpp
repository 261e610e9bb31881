#include "app/window/window_icon.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/math.h"

namespace kerf::app {
namespace {

constexpr int kSide = 64;       // [px]
constexpr double kApart = 3.5;  // half of the gap that the blade leaves [px]
constexpr int kSamples = 4;     // along each side of a pixel

/// A colour multiplied by how much of the place it covers.
using Color = Eigen::Vector4d;

Color opaque(double red, double green, double blue) {
    return {red, green, blue, 1};
}

/// The colour at a place, from the middle of the icon [px].
Color colorAt(const Vec2& at) {
    const Vec2 along = Vec2(1, -1).normalized();
    const double aside = at.x() * along.y() - at.y() * along.x();
    if (std::abs(aside) < 1.6 && std::abs(at.dot(along)) < 31) {
        return opaque(64, 224, 190);
    }
    const double radius = at.norm();
    if (std::abs(aside) < kApart || radius > 27) {
        return Color::Zero();
    }
    if (radius > 23) {
        return opaque(226, 84, 34);
    }
    return radius > 20 ? opaque(255, 226, 178) : opaque(246, 150, 66);
}

}  // namespace

render::Image windowIcon() {
    render::Image icon{kSide, kSide, std::vector<std::uint8_t>(4U * kSide * kSide)};
    for (int i = 0; i < kSide * kSide; ++i) {
        Color sum = Color::Zero();
        for (int sample = 0; sample < kSamples * kSamples; ++sample) {
            const int line = sample / kSamples;
            const Vec2 inPixel(sample % kSamples + 0.5, line + 0.5);
            sum += colorAt(Vec2(i % kSide, i / kSide) + inPixel / kSamples -
                           Vec2::Constant(kSide / 2.0));
        }
        const double cover = std::max(sum.w(), 1e-9);
        for (int k = 0; k < 3; ++k) {
            icon.pixels[4 * i + k] = static_cast<std::uint8_t>(std::lround(sum[k] / cover));
        }
        icon.pixels[4 * i + 3] =
            static_cast<std::uint8_t>(std::lround(255 * sum.w() / (kSamples * kSamples)));
    }
    return icon;
}

}  // namespace kerf::app
