#pragma once

#include "render/scene/depth_field.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

/// The depth below the skin of each uncut body in use, including undoable ones: measuring it takes
/// long for large ones.
class RestDepths {
  public:
    /// Stores what was measured elsewhere.
    void note(const std::shared_ptr<const UncutBody>& body, render::DepthField depth);
    /// The depth of a body, measured now if not stored.
    const render::DepthField& of(const std::shared_ptr<const UncutBody>& body);

  private:
    using Body = std::weak_ptr<const UncutBody>;
    std::map<Body, render::DepthField, std::owner_less<Body>> known_;
};

}  // namespace kerf::app
