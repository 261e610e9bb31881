#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/option_checks.h"
#include "app/cli/verb.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/io/system_file.h"
#include "app/files/jobs/child_process.h"
#include "app/regression/test_result.h"
#include "app/regression/test_session.h"
#include "app/session/session.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

/// The arguments of `kerf test PATH... [--update] ...`, parsed.
struct TestArguments {
    std::vector<std::filesystem::path> paths;
    bool update = false;
    int jobs = 1;                  ///< runs at a time
    std::filesystem::path junit;   ///< empty for none
    std::filesystem::path report;  ///< empty for none
    std::filesystem::path out;     ///< keeps the results of the runs; empty for nowhere
    bool json = false;
};

/// A folder that can't be made is told before anything runs.
void makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder.empty() ? "." : folder, error);
    if (error) {
        throw OutputError(folder.string() + ": the folder could not be made (" + error.message() +
                          ").");
    }
}

/// Where the runs leave their results: the folder that is to keep them, or one that goes with this.
class ResultFolder {
  public:
    explicit ResultFolder(const fs::path& kept)
        : path_(kept.empty() ? temporary_.emplace("kerf-test").path() : kept) {
        makeFolder(path_);
        lock_.emplace(path_);
    }

    /// "3-slice": sessions of several folders may have one name.
    fs::path of(std::size_t number, const fs::path& session) const {
        const fs::path name = expectationFolder(session).stem();
        return path_ / (std::to_string(number) + "-" + name.string());
    }

  private:
    std::optional<TemporaryFolder> temporary_;
    fs::path path_;
    std::optional<FolderLock> lock_;
};

std::string lineAbout(const TestResult& result) {
    std::string line = fmt::format("{:<10} {} ({:.1f} s)", nameOf(result.status),
                                   printable(result.name), result.seconds);
    if (result.judgement.otherDriver) {
        line += " [another driver: by tolerance]";
    }
    for (const Finding& finding : result.judgement.findings) {
        line += "\n           " + printable(finding.sentence);
    }
    for (const std::string& note : result.notes) {
        line += "\n           " + printable(note);
    }
    return line + "\n";
}

/// A report that is asked for: whether it can be written is known before the tests run.
class ReportFile {
  public:
    explicit ReportFile(const fs::path& file) {
        if (!file.empty()) {
            makeFolder(file.parent_path());
            file_.emplace(file);
        }
    }
    /// Formats the results only where the report is asked for: a page holds all pictures.
    void write(const std::vector<TestResult>& results,
               std::string (*format)(const std::vector<TestResult>&)) {
        if (file_) {
            file_->write(format(results));
            file_->commit();
        }
    }

  private:
    std::optional<AtomicFile> file_;
};

/// What a test reads besides its expectation; of a session that can't be read, the session alone.
std::vector<fs::path> inputsOf(const fs::path& session) {
    std::vector<fs::path> files;
    try {
        files = modelFiles(readSession(session));
    } catch (const InputError&) {  // is told by its test
    }
    files.push_back(session);
    return files;
}

/// Whether the test of a session reads a file; what is not there yet is read by none.
bool reads(const fs::path& session, const fs::path& file) {
    std::error_code error;
    if (file.empty()) {
        return false;
    }
    const auto isFile = [&](const fs::path& input) { return fs::equivalent(file, input, error); };
    return fs::equivalent(fs::absolute(file, error).parent_path(), expectationFolder(session),
                          error) ||
           (fs::exists(file, error) && std::ranges::any_of(inputsOf(session), isFile));
}

/// Results must not be taken for what a test expects.
void requireNoExpectation(const fs::path& out, const fs::path& session) {
    std::error_code error;
    const fs::path expected = fs::canonical(expectationFolder(session), error);
    if (!error && !out.empty() && leadsInside(expected, out)) {
        throw UsageError("--out " + out.string() +
                         ": this folder holds what a test expects; choose another");
    }
}

/// A report must take the place neither of what the tests read nor of the other report.
void checkTargets(const TestArguments& arguments, const std::vector<fs::path>& sessions) {
    if (!arguments.junit.empty() &&
        arguments.junit.lexically_normal() == arguments.report.lexically_normal()) {
        throw UsageError("--junit and --report name one file; choose two");
    }
    for (const fs::path& session : sessions) {
        requireNoExpectation(arguments.out, session);
        for (const fs::path& target : {arguments.junit, arguments.report}) {
            if (reads(session, target)) {
                throw UsageError(target.string() +
                                 ": the tests read this file; choose another for the report");
            }
        }
    }
}

/// The tests of one call: which there are, and what came of them.
class TestRun {
  public:
    TestRun(const TestArguments& arguments, std::ostream& out)
        : arguments_(arguments),
          out_(out),
          sessions_(findSessions(arguments.paths)),
          folder_(arguments.out) {
        checkTargets(arguments, sessions_);
    }

    /// All of them, by name.
    const std::vector<TestResult>& run() {
        const std::vector<fs::path> pending = judgeThoseWithoutRun();
        std::vector<std::vector<std::string>> runs;
        runs.reserve(pending.size());
        for (const fs::path& session : pending) {
            runs.push_back(runArguments(session, folder_.of(runs.size(), session), false));
        }
        runChildren(runs, arguments_.jobs, [&](std::size_t run, const ChildOutcome& outcome) {
            const fs::path& session = pending[run];
            add(judgeRun(session, folder_.of(run, session), outcome, arguments_.update));
        });
        addThoseNotRun();
        std::ranges::sort(results_, {}, &TestResult::session);
        return results_;
    }

    std::string lastLine() const {
        const auto failed = std::ranges::count_if(results_, &TestResult::failed);
        const auto notRun = std::ranges::count(results_, TestStatus::notRun, &TestResult::status);
        const std::string tests = counted(sessions_.size(), "test", "tests");
        if (notRun > 0) {
            return tests + ", " + std::to_string(notRun) + " not run, " + std::to_string(failed) +
                   " failed\n";
        }
        return tests + ", " + (failed == 0 ? "all hold" : std::to_string(failed) + " failed") +
               "\n";
    }

  private:
    /// The others, which are to be run.
    std::vector<fs::path> judgeThoseWithoutRun() {
        std::vector<fs::path> pending;
        for (const fs::path& session : sessions_) {
            if (auto result = judgeWithoutRun(session, arguments_.update)) {
                add(std::move(*result));
            } else {
                pending.push_back(session);
            }
        }
        return pending;
    }

    /// A run that was stopped must not look green to those who read its results alone.
    void addThoseNotRun() {
        const std::size_t done = results_.size();
        for (const fs::path& session : sessions_) {
            if (std::ranges::count(results_, session, &TestResult::session) == 0) {
                results_.push_back(resultOfNoRun(session));
            }
        }
        if (done < sessions_.size()) {
            spdlog::error("Stopped: {} of {} not run.", sessions_.size() - done,
                          counted(sessions_.size(), "test was", "tests were"));
        }
    }

    void add(TestResult result) {
        if (!arguments_.json) {
            out_ << lineAbout(result) << std::flush;
        }
        results_.push_back(std::move(result));
    }

    const TestArguments& arguments_;
    std::ostream& out_;
    const std::vector<fs::path> sessions_;
    const ResultFolder folder_;
    std::vector<TestResult> results_;
};

int exitCodeOf(const TestResult& result) {
    switch (result.status) {
        case TestStatus::failed:
        case TestStatus::notRun:
            return kExitCheckFailed;
        case TestStatus::unreadable:
            return kExitInput;
        case TestStatus::unwritable:
            return kExitLimit;
        default:
            return kExitDone;
    }
}

/// The highest one of them all.
int exitCodeOf(const std::vector<TestResult>& results) {
    int exitCode = kExitDone;
    for (const TestResult& result : results) {
        exitCode = std::max(exitCode, exitCodeOf(result));
    }
    return exitCode;
}

int runTests(const TestArguments& arguments, std::ostream& out) {
    refuseFileAsFolder(arguments.out);
    const Interruption interruption;
    TestRun run(arguments, out);
    ReportFile junit(arguments.junit);
    ReportFile report(arguments.report);
    const std::vector<TestResult>& results = run.run();
    out << (arguments.json ? formatJson(results) : run.lastLine()) << std::flush;
    junit.write(results, formatJUnit);
    report.write(results, formatTestReport);
    return exitCodeOf(results);
}

std::function<int()> describeTest(CLI::App& verb) {
    const auto arguments = std::make_shared<TestArguments>();
    verb.add_option("PATH", arguments->paths, "A session, or a folder to search for *.kerf.json")
        ->required()
        ->check(refuseEmpty);
    verb.add_flag("--update", arguments->update,
                  "Write or renew the expectations (NAME.expected beside NAME.kerf.json)");
    addJobs(verb, arguments->jobs);
    verb.add_option("--junit", arguments->junit, "Write the results as JUnit XML")
        ->check(refuseEmpty)
        ->type_name("FILE");
    verb.add_option("--report", arguments->report,
                    "Write a page with expected, actual and different pictures, and plots")
        ->check(refuseEmpty)
        ->type_name("FILE.html");
    addOut(verb, arguments->out, "Keep the output of the runs, a folder for each");
    verb.add_flag("--json", arguments->json, "Print one JSON object");
    return [arguments] { return runTests(*arguments, std::cout); };
}

}  // namespace

const Verb kTestVerb{
    "test", "Run sessions as regression tests: states, counts, volumes and pictures", describeTest};

}  // namespace kerf::app
