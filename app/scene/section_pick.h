#pragma once

#include "app/scene/editor_scene.h"
#include "app/scene/readout/cut_preview.h"
#include "render/scene/camera.h"
#include "render/scene/overlays.h"

namespace kerf::app {

/// The visible point of the body's surface along a ray, behind an optional section plane: none if
/// the ray hits the filled section first.
std::optional<SurfacePoint> pickVisible(EditorScene& scene, const render::Ray& ray,
                                        const std::optional<render::SectionPlane>& section);

}  // namespace kerf::app
