#pragma once

#include "app/files/jobs/background_job.h"
#include "app/files/jobs/child_runs.h"
#include "app/regression/judgement.h"
#include "app/regression/test_result.h"
#include "app/session/session.h"

namespace kerf::app {

/// The sessions at these paths: files, and *.kerf.json in folders, each once, by name; skips
/// folders that are hidden, named *.expected or behind links. Includes folders that can't be
/// searched. Throws InputError for a path that is missing or leads to none.
std::vector<std::filesystem::path> findSessions(const std::vector<std::filesystem::path>& paths);

/// The arguments of the run of a session into a folder, with or without the state hashes in the
/// session's own checks.
std::vector<std::string> runArguments(const std::filesystem::path& session,
                                      const std::filesystem::path& results, bool hashChecks);

/// The result of a test without a run: its expectation can't be read, or is missing without
/// `update`; nothing if it must be run.
std::optional<TestResult> judgeWithoutRun(const std::filesystem::path& session, bool update);

/// The result of a test that was not run, since the tests were stopped.
TestResult resultOfNoRun(const std::filesystem::path& session);

/// Judges a finished run, with its results in `results`, by the expectation beside the session.
/// With `update` that is made or renewed instead, unless a check of the session failed. Throws
/// gpu::ContextError if the run found no usable OpenGL.
TestResult judgeRun(const std::filesystem::path& session, const std::filesystem::path& results,
                    const ChildOutcome& outcome, bool update);

/// Writes a session as a regression test: NAME.kerf.json as `file`, and beside it NAME.expected
/// from a run in a separate process. If that run or a check fails, neither is written. Keeps masks,
/// limits and tolerances of an earlier expectation. Throws InputError, OutputError, and
/// WorkCancelled soon after `progress` was cancelled.
void makeTest(const Session& session, const std::filesystem::path& file, WorkProgress& progress);

/// Makes or renews the expectation in a folder from a run: the tables, the pictures, and
/// expected.json last. Keeps masks, limits and tolerances of an earlier expectation; removes
/// pictures that the session does not take. Throws OutputError, and InputError if the earlier one
/// can't be read.
void writeExpectation(const std::filesystem::path& expectationFolder, const RunResults& results);

}  // namespace kerf::app
