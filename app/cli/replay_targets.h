#pragma once

#include "app/cli/replay_arguments.h"
#include "app/session/session.h"

namespace kerf::app {

/// Throws UsageError where a replay would write over what it reads (session, models, material,
/// hashes, reference pictures), or would write two of its results to one file.
void checkReplayTargets(const Session& session, const ReplayArguments& arguments);

}  // namespace kerf::app
