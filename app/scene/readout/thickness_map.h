#pragma once

#include <memory>
#include <string>

#include "app/files/jobs/background_job.h"
#include "render/scene/surface_field.h"
#include "sim/run/simulation.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

/// The thickness of a body at each vertex. It is worked out on a thread of its own while the body
/// rests, and kept until a newer one is there or the body was cut.
class ThicknessMap {
  public:
    /// Where it is `wanted` and the body `rests`: begins with the body as it is, unless that is
    /// known, and takes what is ready. True where values() are others than before.
    bool follow(Simulation& simulation, bool wanted, bool rests);
    /// Null where there are none; see surfaceThickness().
    const std::shared_ptr<const render::FieldValues>& values() const { return values_; }
    /// "" where the values are those of now, or what they are instead.
    std::string note(const Simulation& simulation) const;
    bool working() const { return job_ != nullptr; }

  private:
    /// A body at one moment.
    struct Subject {
        int revision = -1;
        int step = 0;
        int triangles = 0;  ///< other ones: it was cut since
        std::shared_ptr<const UncutBody> uncut;

        static Subject of(const Simulation& simulation);
        bool isCutLike(const Subject& other) const {
            return triangles == other.triangles && uncut == other.uncut;
        }
    };
    void begin(Simulation& simulation);
    bool takeReady();

    Subject known_;    ///< what values_ are of
    Subject working_;  ///< what job_ is about
    std::shared_ptr<const render::FieldValues> values_;
    std::unique_ptr<BackgroundJob<render::FieldValues>> job_;
};

}  // namespace kerf::app
