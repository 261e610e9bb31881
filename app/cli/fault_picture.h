#pragma once

#include <filesystem>
#include <string>

#include "app/cli/replay/picture_size.h"
#include "app/files/import/model_faults.h"
#include "render/scene/image.h"

namespace kerf::app {

/// A picture of a model with what is wrong with it, and a legend headed by `title`. `file` tells
/// what its numbers mean. Needs a current OpenGL 4.5 context. Throws gpu::OutOfMemory.
render::Image faultPicture(const FoundFaults& found, const std::filesystem::path& file,
                           const std::string& title, const PictureSize& size);

}  // namespace kerf::app
