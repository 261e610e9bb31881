#pragma once

#include "app/files/jobs/background_job.h"
#include "render/scene/depth_field.h"
#include "sim/run/parts/command.h"
#include "sim/run/simulation.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

/// An uncut body with a new placement of a model, with all expensive parts that need no OpenGL.
struct PlacedBody {
    std::shared_ptr<const UncutBody> body;
    render::DepthField depth;  ///< below the skin of the body at rest
};

/// A placement of a model, prepared on a separate thread while the scene continues.
class BodyPlacing {
  public:
    /// Begins to prepare the body of the simulation after `place`.
    BodyPlacing(const Simulation& simulation, const Place& place);

    const Place& command() const { return place_; }
    bool done() const { return job_.done(); }
    /// Takes the result once it is done, only once. Throws what the thread threw.
    PlacedBody take() { return job_.take(); }
    std::string stage() const { return job_.stage(); }
    double seconds() const { return job_.seconds(); }
    void cancel() { job_.cancel(); }

  private:
    Place place_;
    BackgroundJob<PlacedBody> job_;
};

}  // namespace kerf::app
