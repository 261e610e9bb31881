#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf test PATH...`: sessions as regression tests.
extern const Verb kTestVerb;

}  // namespace kerf::app
