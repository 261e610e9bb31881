#pragma once

#include "app/files/jobs/background_job.h"
#include "app/scene/readout/cut_preview.h"
#include "render/scene/surface_field.h"
#include "sim/run/simulation.h"
#include "sim/run/start/prepared_body.h"

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

/// The thickness of a body at each vertex. It is computed on a separate thread while the body
/// rests, and kept until the next result or cut.
class ThicknessMap {
  public:
    /// If `wanted` and the body `rests`: begins to measure the present body, unless that is known,
    /// and takes a finished result. Returns whether values() have changed.
    bool follow(Simulation& simulation, bool wanted, bool rests);
    /// Null for none; see surfaceThickness().
    const std::shared_ptr<const render::FieldValues>& values() const { return values_; }
    /// A note on outdated values; "" if they are up to date.
    std::string note(const Simulation& simulation) const;
    bool working() const { return job_ != nullptr; }

  private:
    /// A body at one moment.
    struct Subject {
        int revision = -1;
        int step = 0;
        int triangles = 0;  ///< changed by a cut
        std::shared_ptr<const UncutBody> uncut;

        static Subject of(const Simulation& simulation);
        bool isCutLike(const Subject& other) const {
            return triangles == other.triangles && uncut == other.uncut;
        }
    };
    void begin(Simulation& simulation);
    bool takeReady();

    Subject known_;    ///< of values_
    Subject working_;  ///< of job_
    std::shared_ptr<const render::FieldValues> values_;
    std::unique_ptr<BackgroundJob<render::FieldValues>> job_;
};

}  // namespace kerf::app
