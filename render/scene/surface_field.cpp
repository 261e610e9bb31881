#include "render/scene/surface_field.h"

#include <array>

namespace kerf::render {

const FieldInfo& infoOf(SurfaceField field) {
    static constexpr std::array<FieldInfo, kSurfaceFields> kInfos{{
        {"Look", "The colours of the body itself"},
        {"Strain",
         "Largest stretch or compression of the surface in any direction, relative to rest", false,
         false, 0.01F, &kViridis},
        {"Area change", "How much the area of the surface grew (red) or shrank (blue) against rest",
         true, false, 0.01F, &kBlueRed},
        {"Thickness", "Distance straight through the body to its other side", false, true, 0,
         &kViridis},
    }};
    return kInfos[static_cast<std::size_t>(field)];
}

}  // namespace kerf::render
