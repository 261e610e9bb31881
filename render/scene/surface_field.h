#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "render/scene/color_map.h"

namespace kerf::render {

/// What the colours of the surface show: the look, or a quantity at each point of it.
enum class SurfaceField : std::uint8_t { look, strain, area, thickness };
inline constexpr int kSurfaceFields = 4;

/// How the numbers of a quantity are shown.
struct FieldInfo {
    std::string_view name;     ///< "Strain"
    std::string_view meaning;  ///< one sentence for a tooltip
    bool hasSign = false;   ///< its range reaches as far below 0 as above; otherwise it begins at 0
    bool isLength = false;  ///< in metres; otherwise a share, shown in per cent
    float least = 0;        ///< an automatic range reaches at least this far
    const ColorMap* map = &kViridis;
};
const FieldInfo& infoOf(SurfaceField field);

/// What a range of colours goes from and to, in the quantity's own unit (share or m).
struct FieldRange {
    float low = 0;
    float high = 1;
    bool operator==(const FieldRange&) const = default;
};

/// What a person chose to see as colours.
struct FieldChoice {
    SurfaceField field = SurfaceField::look;
    /// The end of the range; none: the largest value of now, rounded up.
    std::optional<float> high;
    bool operator==(const FieldChoice&) const = default;
};

/// Values that were worked out elsewhere: at 2 * vertex + kind (0: skin, 1: wall), below 0 where
/// there is none.
using FieldValues = std::vector<float>;

/// The quantity that a picture shows.
struct FieldView {
    FieldChoice choice;
    /// Values of SurfaceField::thickness; strains are computed on the GPU.
    std::shared_ptr<const FieldValues> values;
};

}  // namespace kerf::render
