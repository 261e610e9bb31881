#pragma once

#include <memory>
#include <string>

#include "app/files/jobs/background_job.h"
#include "render/scene/depth_field.h"
#include "sim/run/parts/command.h"
#include "sim/run/simulation.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

/// An uncut body with a model put elsewhere, and all that takes long of that and needs no OpenGL.
struct PlacedBody {
    std::shared_ptr<const UncutBody> body;
    render::DepthField depth;  ///< below the skin of the body at rest
};

/// A placement of a model on its way: prepared on a thread of its own, while the scene goes on as
/// it is.
class BodyPlacing {
  public:
    /// Begins to prepare what `place` will make of the body of the simulation.
    BodyPlacing(const Simulation& simulation, const Place& place);

    const Place& command() const { return place_; }
    bool done() const { return job_.done(); }
    /// Once it is done, and once only. Throws what the thread threw.
    PlacedBody take() { return job_.take(); }
    std::string stage() const { return job_.stage(); }
    double seconds() const { return job_.seconds(); }
    void cancel() { job_.cancel(); }

  private:
    Place place_;
    BackgroundJob<PlacedBody> job_;
};

}  // namespace kerf::app
