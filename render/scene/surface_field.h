#pragma once

#include "render/scene/overlays.h"

namespace kerf::render {

/// Colours for numbers, equally spaced from the lowest to the highest, interpolated linearly.
using ColorMap = std::array<DisplayColor, 11>;

/// Of 0xRRGGBB.
constexpr ColorMap colorsFrom(const std::array<std::uint32_t, 11>& hex) {
    ColorMap map{};
    for (std::size_t i = 0; i < map.size(); ++i) {
        map[i] = {static_cast<std::uint8_t>(hex[i] >> 16U), static_cast<std::uint8_t>(hex[i] >> 8U),
                  static_cast<std::uint8_t>(hex[i])};
    }
    return map;
}

/// Viridis, plasma and inferno by van der Walt and Smith, cividis by Nunez, Anderton and Renslow
/// (matplotlib 3.6, CC0), each in eleven of its 256 colours: perceptually uniform, also in grey.
inline constexpr ColorMap kViridis =
    colorsFrom({0x440154, 0x482576, 0x414487, 0x35608d, 0x2a788e, 0x21908c, 0x22a884, 0x43bf71,
                0x7ad151, 0xbbdf27, 0xfde725});
inline constexpr ColorMap kPlasma =
    colorsFrom({0x0d0887, 0x41049d, 0x6a00a8, 0x8f0da4, 0xb12a90, 0xcc4778, 0xe16462, 0xf2844b,
                0xfca636, 0xfcce25, 0xf0f921});
inline constexpr ColorMap kInferno =
    colorsFrom({0x000004, 0x160b39, 0x420a68, 0x6a176e, 0x932667, 0xbc3754, 0xdd513a, 0xf37819,
                0xfca50a, 0xf6d746, 0xfcffa4});
inline constexpr ColorMap kCividis =
    colorsFrom({0x00224e, 0x083370, 0x35456c, 0x4f576c, 0x666970, 0x7d7c78, 0x948e77, 0xaea371,
                0xc8b866, 0xe5cf52, 0xfee838});
/// RdBu of ColorBrewer (Brewer and Harrower, colorbrewer2.org) from blue to red: pale in the
/// middle, safe for colour blindness. For signed values.
inline constexpr ColorMap kBlueRed =
    colorsFrom({0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xf7f7f7, 0xfddbc7, 0xf4a582,
                0xd6604d, 0xb2182b, 0x67001f});

/// The colour maps by name.
enum class ColorMapName : std::uint8_t { viridis, plasma, inferno, cividis, blueRed };
struct ColorMapRow {
    const char* name;
    ColorMap colors;
};
inline constexpr std::array kColorMaps{
    ColorMapRow{"Viridis", kViridis},     ColorMapRow{"Plasma", kPlasma},
    ColorMapRow{"Inferno", kInferno},     ColorMapRow{"Cividis", kCividis},
    ColorMapRow{"Blue to red", kBlueRed},
};

/// The meaning of the surface colours: the look, or a quantity at each point.
enum class SurfaceField : std::uint8_t { look, strain, area, thickness };
inline constexpr int kSurfaceFields = 4;

/// The display of a quantity.
struct FieldInfo {
    std::string_view name;     ///< "Strain"
    std::string_view meaning;  ///< one sentence for a tooltip
    bool hasSign = false;      ///< its automatic range reaches as far below 0 as above
    bool isLength = false;     ///< in metres; otherwise a share, shown in per cent
    float least = 0;           ///< an automatic range is at least as wide
    ColorMapName map = ColorMapName::viridis;  ///< unless another is chosen
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
    /// The range; none: automatic.
    std::optional<FieldRange> range;
    std::optional<ColorMapName> map;  ///< none: the quantity's own
    bool operator==(const FieldChoice&) const = default;
};
/// The colours of a choice.
const ColorMapRow& colorsOf(const FieldChoice& choice);

/// A value, and how much of the surface has it.
struct FieldSample {
    float value = 0;
    float area = 0;
};
/// The automatic range: from the value that 2 % of the area are below to the one that 98 % are
/// below, rounded outwards so that it stands still while the body moves a little. With a sign it
/// reaches as far below 0 as above.
FieldRange automaticRange(std::vector<FieldSample> samples, const FieldInfo& info);

/// Values computed elsewhere: at 2 * vertex + kind (0: skin, 1: wall), below 0 for none.
using FieldValues = std::vector<float>;

/// The quantity that a picture shows.
struct FieldView {
    FieldChoice choice;
    /// Values of SurfaceField::thickness; strains are computed on the GPU.
    std::shared_ptr<const FieldValues> values;
};

}  // namespace kerf::render
