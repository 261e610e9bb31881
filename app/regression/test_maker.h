#pragma once

#include <filesystem>

#include "app/files/jobs/work_progress.h"
#include "app/session/session.h"

namespace kerf::app {

/// Writes a session as a regression test: NAME.kerf.json as `file`, and beside it NAME.expected,
/// what a run of it in a process of its own comes out like. Where that run fails or a check of the
/// session does, neither is written. Of an earlier expectation there, masks, limits and tolerances
/// stay. Throws InputError, OutputError, and WorkCancelled soon after `progress` was cancelled.
void makeTest(const Session& session, const std::filesystem::path& file, WorkProgress& progress);

}  // namespace kerf::app
