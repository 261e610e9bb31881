#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf sweep STUDY --out DIR`: the runs of a study that are not done yet.
extern const Verb kSweepVerb;

}  // namespace kerf::app
