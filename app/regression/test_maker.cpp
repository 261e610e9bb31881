#include "app/regression/test_maker.h"

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/regression/expectation_writer.h"
#include "app/regression/test_session.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& why) {
    throw OutputError("No test was saved: " + why);
}

/// Runs a session file into `results`.
void run(const fs::path& file, int steps, const fs::path& results, WorkProgress& progress) {
    std::vector<std::string> arguments = runArguments(file, results, true);
    arguments.emplace_back("--jsonl");  // a line per step
    const auto tell = [&](int done) {
        progress.enter("Replaying step " + std::to_string(std::min(done, steps)) + " of " +
                       std::to_string(steps));
    };
    tell(0);
    const ChildOutcome outcome = runChild(arguments, progress, tell);
    if (outcome.exitCode != kExitDone && outcome.exitCode != kExitCheckFailed) {
        refuse("the replay did not finish, " + sentenceAbout(outcome, file.parent_path()));
    }
}

/// A test that fails from the start is none.
void requireNoFailures(const std::vector<std::string>& failures) {
    if (failures.size() == 1) {
        refuse(failures.front());
    } else if (!failures.empty()) {
        refuse(failures.front() + " (" + std::to_string(failures.size() - 1) + " more.)");
    }
}

}  // namespace

void makeTest(const Session& session, const fs::path& file, WorkProgress& progress) {
    const TemporaryFolder folder("kerf-test");
    const fs::path copy = folder.path() / file.filename();
    writeOutputFile(copy, formatSession(session, folder.path()));
    run(copy, session.steps, folder.path() / "results", progress);
    const RunResults results = readResults(folder.path() / "results", session);
    requireNoFailures(results.failures);
    progress.enter("Writing");
    writeExpectation(expectationFolder(file), results);
    writeOutputFile(file, formatSession(session, file.parent_path()));
}

}  // namespace kerf::app
