#pragma once

#include "app/cli/replay_arguments.h"
#include "app/session/session.h"

namespace kerf::app {

/// Throws UsageError if a replay would overwrite an input (session, models, material, hashes,
/// reference pictures), or write two results to one file.
void checkReplayTargets(const Session& session, const ReplayArguments& arguments);

}  // namespace kerf::app
