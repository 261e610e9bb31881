#pragma once

#include <optional>

#include "render/scene/camera.h"

namespace kerf::app {

/// Takes the camera from one view to another within a moment, so that the eye can follow. Whatever
/// is done meanwhile is done in the view at its end: nothing depends on how far it has come.
class CameraFlight {
  public:
    static constexpr double kSeconds = 0.22;

    /// Begins to fly from the view that is shown to another.
    void start(const render::Camera& shown, const render::Camera& to);
    bool flying() const { return way_.has_value(); }
    /// The view at the end of the flight; `shown` while there is none.
    render::Camera destination(const render::Camera& shown) const;

    /// Moves the view on by `seconds`; true while it moved.
    bool advance(render::Camera& shown, double seconds);
    /// Ends the flight at once.
    void land(render::Camera& shown);

  private:
    struct Way {
        render::Camera from;
        render::Camera to;
        double flown = 0;  ///< [s]
    };
    std::optional<Way> way_;
};

/// The view between two others, `share` 0 to 1: turned the short way, the distance in equal ratios.
render::Camera between(const render::Camera& from, const render::Camera& to, double share);

}  // namespace kerf::app
