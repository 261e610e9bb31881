#pragma once

#include "render/scene/appearance.h"

namespace kerf::app {

/// A material of an .mtl file.
struct ObjMaterial {
    render::SurfaceMaterial material;  ///< without its image
    std::string image;                 ///< the name of its file; "" for none
    std::string leftOut;  ///< an unsupported option of the image, such as "-s"; "" for none
};

/// Reads the text of an .mtl file. Throws InputError for invalid numbers.
std::vector<ObjMaterial> readObjMaterials(std::string_view text);

}  // namespace kerf::app
