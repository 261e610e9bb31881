#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf inspect MODEL`: what a model is and whether it can be cut.
extern const Verb kInspectVerb;

}  // namespace kerf::app
