#pragma once

#include "app/cli/verb.h"

namespace kerf::app {

/// Not for people: model_source runs it to keep the file readers in a process of their own.
extern const Verb kImportWorkerVerb;

}  // namespace kerf::app
