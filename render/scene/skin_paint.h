#pragma once

#include "render/scene/appearance.h"
#include "shaders/shared/skin_records.h"
#include "sim/mesh/skin_attributes.h"

namespace kerf::render {

/// The model's own colours on the skin of the present body: one record for each triangle of skin,
/// grouped by image.
struct SkinPaint {
    /// Triangles that are drawn with one image.
    struct Range {
        int image = -1;  ///< of `appearance`; -1 for none
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    std::vector<shared::SkinRecord> records;
    std::vector<Range> ranges;
    std::shared_ptr<const Appearance> appearance;  ///< may be null: colours of corners alone
};

/// A triangle of skin: its place in a BodyView, and its attributes.
struct PaintedTriangle {
    std::uint32_t triangle = 0;
    TriangleAttributes attributes;
};

/// Paints triangles. Those without material have the colours of their corners if `colored`, else
/// those of the look.
SkinPaint paintSkin(const std::vector<PaintedTriangle>& skin, bool colored,
                    std::shared_ptr<const Appearance> appearance);

}  // namespace kerf::render
