#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf doctor`: the graphics driver of this machine, what is right and what not.
extern const Verb kDoctorVerb;

}  // namespace kerf::app
