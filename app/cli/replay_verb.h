#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf replay SESSION --out DIR`: a session headless, and what came of it.
extern const Verb kReplayVerb;

}  // namespace kerf::app
