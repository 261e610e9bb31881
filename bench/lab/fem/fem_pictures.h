#pragma once

#include <string>

#include "bench/lab/fem/loaded_surface.h"
#include "render/scene/image.h"

namespace kerf::app {

/// A strip of three pictures of one size and view: Kerf's body, the finite elements, and Kerf's
/// body with the edges of the finite elements over it. Needs a current OpenGL 4.5 context.
render::Image drawBesideEachOther(const std::string& title, const LoadedSurface& kerf,
                                  const LoadedSurface& elements);

}  // namespace kerf::app
