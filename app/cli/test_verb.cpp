#include "app/cli/test_verb.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <thread>

#include "app/cli/exit_codes.h"
#include "app/files/file_io.h"
#include "app/files/progress_line.h"
#include "app/files/temporary_folder.h"
#include "app/regression/test_report.h"
#include "app/regression/test_session.h"
#include "gpu/context.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

/// Where the runs leave their results: the folder that is to keep them, or one that goes with this.
class ResultFolder {
  public:
    explicit ResultFolder(const fs::path& kept)
        : path_(kept.empty() ? temporary_.emplace("kerf-test").path() : kept) {}

    fs::path of(std::size_t run) const { return path_ / std::to_string(run); }

  private:
    std::optional<TemporaryFolder> temporary_;
    fs::path path_;
};

int jobsOf(const TestArguments& arguments) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    return arguments.jobs > 0 ? arguments.jobs : static_cast<int>(cores);
}

std::string lineAbout(const TestResult& result) {
    std::string line =
        fmt::format("{:<10} {} ({:.1f} s)", nameOf(result.status), result.name, result.seconds);
    if (result.judgement.otherDriver) {
        line += " [another driver: by tolerance]";
    }
    for (const Finding& finding : result.judgement.findings) {
        line += "\n           " + finding.sentence;
    }
    return line + "\n";
}

std::vector<TestResult> runTests(const std::vector<fs::path>& sessions, const ResultFolder& folder,
                                 const TestArguments& arguments, std::ostream& out) {
    std::vector<std::vector<std::string>> runs;
    runs.reserve(sessions.size());
    for (const fs::path& session : sessions) {
        runs.push_back(runArguments(session, folder.of(runs.size())));
    }
    std::vector<TestResult> results(sessions.size());
    runChildren(runs, jobsOf(arguments), [&](std::size_t run, const ChildOutcome& outcome) {
        if (outcome.exitCode == kExitNoOpenGl) {
            throw gpu::ContextError(sentenceAbout(outcome));
        }
        results[run] = judgeRun(sessions[run], folder.of(run), outcome, arguments.update);
        if (!arguments.json) {
            out << lineAbout(results[run]) << std::flush;
        }
    });
    return results;
}

std::string lastLine(const std::vector<TestResult>& results) {
    const auto failed = std::ranges::count_if(results, &TestResult::failed);
    return counted(results.size(), "test", "tests") + ", " +
           (failed == 0 ? "all hold" : std::to_string(failed) + " failed") + "\n";
}

int exitCodeOf(const std::vector<TestResult>& results) {
    const auto isUnreadable = [](const TestResult& result) {
        return result.status == TestStatus::unreadable;
    };
    if (std::ranges::any_of(results, isUnreadable)) {
        return kExitInput;
    }
    return std::ranges::any_of(results, &TestResult::failed) ? kExitCheckFailed : kExitDone;
}

}  // namespace

int testVerb(const TestArguments& arguments, std::ostream& out) {
    const std::vector<fs::path> sessions = findSessions(arguments.paths);
    const ResultFolder folder(arguments.out);
    const std::vector<TestResult> results = runTests(sessions, folder, arguments, out);
    if (!arguments.junit.empty()) {
        writeOutputFile(arguments.junit, formatJUnit(results));
    }
    if (!arguments.report.empty()) {
        writeOutputFile(arguments.report, formatTestReport(results));
    }
    out << (arguments.json ? formatJson(results) : lastLine(results));
    return exitCodeOf(results);
}

}  // namespace kerf::app
