#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf materials [NAME|FILE]`: the materials that come with Kerf.
extern const Verb kMaterialsVerb;

}  // namespace kerf::app
