#include "render/scene/surface_field.h"

namespace kerf::render {
namespace {

constexpr double kBelow =
    0.02;                   // share of the area that an automatic range leaves out, at each end
constexpr int kParts = 10;  // of a range, about: to which its ends are rounded

/// The value that this share of the area lies below; sorted by value.
float percentile(const std::vector<FieldSample>& samples, double share) {
    double left = 0;
    for (const FieldSample& sample : samples) {
        left += share * sample.area;
    }
    for (const FieldSample& sample : samples) {
        left -= sample.area;
        if (left <= 0) {
            return sample.value;
        }
    }
    return samples.back().value;
}

/// 1, 2 or 5 times a power of ten, the next above.
double roundStep(double least) {
    const double ten = std::pow(10.0, std::floor(std::log10(least)));
    return least <= ten ? ten : least <= 2 * ten ? 2 * ten : least <= 5 * ten ? 5 * ten : 10 * ten;
}

}  // namespace

const FieldInfo& infoOf(SurfaceField field) {
    static constexpr std::array<FieldInfo, kSurfaceFields> kInfos{{
        {"Look", "The colours of the body itself"},
        {"Strain",
         "Largest stretch or compression of the surface in any direction, relative to rest", false,
         false, 0.01F},
        {"Area change", "How much the area of the surface grew (red) or shrank (blue) against rest",
         true, false, 0.01F, ColorMapName::blueRed},
        {"Thickness", "Distance straight through the body to its other side", false, true, 1e-9F},
    }};
    return kInfos[static_cast<std::size_t>(field)];
}

const ColorMapRow& colorsOf(const FieldChoice& choice) {
    return kColorMaps[static_cast<std::size_t>(choice.map.value_or(infoOf(choice.field).map))];
}

FieldRange automaticRange(std::vector<FieldSample> samples, const FieldInfo& info) {
    constexpr double kSlack = 1e-3;  // of a step: noise takes no further one
    std::ranges::sort(samples, {}, &FieldSample::value);
    double low = samples.empty() ? 0 : percentile(samples, kBelow);
    double high = samples.empty() ? 0 : percentile(samples, 1 - kBelow);
    if (info.hasSign) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    const double step = roundStep(std::max<double>(high - low, info.least) / kParts);
    low = step * std::floor(low / step + kSlack);
    high = step * std::ceil(high / step - kSlack);
    if (high - low < info.least) {
        high = info.hasSign ? info.least : low + info.least;
        low = info.hasSign ? -info.least : low;
    }
    return {static_cast<float>(low), static_cast<float>(high)};
}

}  // namespace kerf::render
