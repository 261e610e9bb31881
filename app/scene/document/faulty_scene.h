#pragma once

#include "app/files/import/model_faults.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "render/soup_body.h"

namespace kerf::app {

/// A drawable model with its faults, whether it can be cut or not: plain grey on a floor, in
/// metres, with coloured lines and dots at faults.
class FaultyScene {
  public:
    /// `file` determines the unit of the model. Needs a current OpenGL 4.5 context. Throws
    /// gpu::OutOfMemory.
    FaultyScene(const FoundFaults& found, const std::filesystem::path& file);

    /// Valid as long as this is.
    render::SceneView view() const;
    /// From the front right above; the model fills the view.
    render::Camera camera() const;
    const Bounds& bounds() const { return bounds_; }
    /// The lines and dots with their meaning, for a legend.
    const std::vector<render::Marks>& marks() const { return *marks_; }

  private:
    Bounds bounds_;  ///< [m]
    render::SoupBody body_;
    std::shared_ptr<const std::vector<render::Marks>> marks_;
};

}  // namespace kerf::app
