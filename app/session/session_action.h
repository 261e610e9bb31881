#pragma once

#include <string>
#include <vector>

#include "app/session/session.h"

namespace kerf::app {

/// Reads an event of a session that stands alone, without its step: {"type": "lift"}. What is no
/// mistake but means nothing is told in `warnings`. Throws InputError naming the type and the key
/// ("grab.radius: expected a number (1e-09 to 1e+06).").
SessionAction parseAction(const std::string& text, std::vector<std::string>& warnings);
/// Reads the camera of a `view` that stands alone; the colours of one belong to the whole session.
/// Throws InputError ("view.eye: expected three numbers.").
render::Camera parseCamera(const std::string& text, std::vector<std::string>& warnings);

}  // namespace kerf::app
