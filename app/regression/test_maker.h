#pragma once

#include "app/files/jobs/background_job.h"
#include "app/session/session.h"

namespace kerf::app {

/// Writes a session as a regression test: NAME.kerf.json as `file`, and beside it NAME.expected
/// from a run in a separate process. If that run or a check fails, neither is written. Keeps masks,
/// limits and tolerances of an earlier expectation. Throws InputError, OutputError, and
/// WorkCancelled soon after `progress` was cancelled.
void makeTest(const Session& session, const std::filesystem::path& file, WorkProgress& progress);

}  // namespace kerf::app
