#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf experiment NAME`: the laboratory, a program of its own, kerf-lab.
extern const Verb kExperimentVerb;

}  // namespace kerf::app
