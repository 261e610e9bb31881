#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "render/scene/overlays.h"

namespace kerf::render {

/// Colours for numbers, equally spaced from the lowest to the highest, interpolated linearly.
using ColorMap = std::array<DisplayColor, 11>;

/// Viridis by van der Walt and Smith (matplotlib, CC0), in eleven of its 256 colours: perceptually
/// uniform, also in grey. For ranges from 0.
inline constexpr ColorMap kViridis{{{68, 1, 84},
                                    {72, 37, 118},
                                    {65, 68, 135},
                                    {53, 96, 141},
                                    {42, 120, 142},
                                    {33, 144, 140},
                                    {34, 168, 132},
                                    {67, 191, 113},
                                    {122, 209, 81},
                                    {187, 223, 39},
                                    {253, 231, 37}}};
/// RdBu of ColorBrewer (Brewer and Harrower, colorbrewer2.org) from blue to red: pale in the
/// middle, safe for colour blindness. For signed values.
inline constexpr ColorMap kBlueRed{{{5, 48, 97},
                                    {33, 102, 172},
                                    {67, 147, 195},
                                    {146, 197, 222},
                                    {209, 229, 240},
                                    {247, 247, 247},
                                    {253, 219, 199},
                                    {244, 165, 130},
                                    {214, 96, 77},
                                    {178, 24, 43},
                                    {103, 0, 31}}};

/// The meaning of the surface colours: the look, or a quantity at each point.
enum class SurfaceField : std::uint8_t { look, strain, area, thickness };
inline constexpr int kSurfaceFields = 4;

/// The display of a quantity.
struct FieldInfo {
    std::string_view name;     ///< "Strain"
    std::string_view meaning;  ///< one sentence for a tooltip
    bool hasSign = false;   ///< its range reaches as far below 0 as above; otherwise it begins at 0
    bool isLength = false;  ///< in metres; otherwise a share, shown in per cent
    float least = 0;        ///< an automatic range reaches at least this far
    const ColorMap* map = &kViridis;
};
const FieldInfo& infoOf(SurfaceField field);

/// The limits of a range of colours, in the quantity's unit (share or m).
struct FieldRange {
    float low = 0;
    float high = 1;
    bool operator==(const FieldRange&) const = default;
};

/// The chosen quantity for the colours.
struct FieldChoice {
    SurfaceField field = SurfaceField::look;
    /// The end of the range; none: the largest present value, rounded up.
    std::optional<float> high;
    bool operator==(const FieldChoice&) const = default;
};

/// Values computed elsewhere: at 2 * vertex + kind (0: skin, 1: wall), below 0 for none.
using FieldValues = std::vector<float>;

/// The quantity that a picture shows.
struct FieldView {
    FieldChoice choice;
    /// Values of SurfaceField::thickness; strains are computed on the GPU.
    std::shared_ptr<const FieldValues> values;
};

}  // namespace kerf::render
