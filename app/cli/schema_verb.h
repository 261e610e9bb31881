#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// `kerf schema [KIND]`: the JSON Schema of sessions or materials.
extern const Verb kSchemaVerb;

}  // namespace kerf::app
