#pragma once

#include <optional>
#include <vector>

#include "app/scene/readout/cut_preview.h"

namespace kerf {
class Simulation;
}

namespace kerf::app {

/// Searches the surface of a body under the pointer and ahead of the blade, and caches the last
/// results: nothing is read back from the GPU or searched again while body and query are unchanged.
class SurfaceLook {
  public:
    /// Finds the point at which a ray hits the body, like pickSurface().
    std::optional<SurfacePoint> pick(Simulation& simulation, const render::Ray& ray);
    /// Finds where a blade would cut the body on its path, like previewCut().
    const CutPreview& preview(Simulation& simulation, const std::vector<Blade>& way);

    /// Number of searches through the triangles so far, for tests.
    int searches() const { return searches_; }

  private:
    struct Pick {
        int bodyRevision = -1;
        render::Ray ray;
        std::optional<SurfacePoint> point;
    };
    struct Preview {
        int bodyRevision = -1;
        std::vector<Blade> way;
        CutPreview cut;
    };

    Pick pick_;
    Preview preview_;
    int searches_ = 0;
};

}  // namespace kerf::app
