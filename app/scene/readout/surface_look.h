#pragma once

#include <optional>
#include <vector>

#include "app/scene/readout/cut_preview.h"

namespace kerf {
class Simulation;
}

namespace kerf::app {

/// Looks at the surface of a body for what is under the pointer and before the blade, and remembers
/// the last answers: nothing is read back from the GPU nor searched again while neither the body
/// nor the question has changed.
class SurfaceLook {
  public:
    /// Finds the point at which a ray meets the body, as pickSurface().
    std::optional<SurfacePoint> pick(Simulation& simulation, const render::Ray& ray);
    /// Finds where a blade would meet the body on its way, as previewCut().
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
