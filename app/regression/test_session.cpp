#include "app/regression/test_session.h"

#include <algorithm>
#include <set>

#include "app/files/model_source.h"
#include "app/regression/expectation_writer.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSessionEnding = ".kerf.json";
// What a child says by its exit code: docs/cli.md.
constexpr int kDone = 0;
constexpr int kCheckFailed = 1;
constexpr int kInputError = 3;

bool isSession(const fs::path& file) {
    return file.filename().string().ends_with(kSessionEnding);
}

void searchFolder(const fs::path& folder, std::set<fs::path>& sessions) {
    for (auto entry = fs::recursive_directory_iterator(folder);
         entry != fs::recursive_directory_iterator(); ++entry) {
        if (entry->is_directory() && entry->path().extension() == ".expected") {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file() && isSession(entry->path())) {
            sessions.insert(entry->path().lexically_normal());
        }
    }
}

std::string nameOfTest(const fs::path& session) {
    std::string name = session.generic_string();
    if (name.ends_with(kSessionEnding)) {
        name.resize(name.size() - kSessionEnding.size());
    }
    return name;
}

void fail(TestResult& result, TestStatus status, const std::string& part,
          const std::string& sentence) {
    result.status = status;
    result.judgement.findings.push_back({part, -1, sentence});
}

void renew(TestResult& result, const RunResults& run, bool isNew) {
    if (!run.failures.empty()) {
        result.status = TestStatus::failed;
        return;
    }
    if (isNew || !result.judgement.holds() || result.judgement.otherDriver) {
        writeExpectation(expectationFolder(result.session), run);
        result.status = isNew ? TestStatus::made : TestStatus::renewed;
    }
}

void judgeResults(TestResult& result, bool update) {
    const RunResults run = readResults(result.results, readSession(result.session));
    const fs::path expected = expectationFolder(result.session);
    const bool isNew = !fs::exists(expected / kExpectedFile);
    if (!isNew) {
        result.judgement = judge(expected, run, result.results / "diff");
    } else if (!update) {
        fail(result, TestStatus::failed, "expectation",
             "There is no " + (expected / kExpectedFile).string() +
                 "; make it with kerf test --update " + result.session.string() + ".");
        return;
    }
    result.status = result.judgement.holds() ? TestStatus::passed : TestStatus::failed;
    if (update) {
        renew(result, run, isNew);
    }
}

}  // namespace

std::vector<fs::path> findSessions(const std::vector<fs::path>& paths) {
    std::set<fs::path> sessions;
    for (const fs::path& path : paths) {
        if (fs::is_directory(path)) {
            searchFolder(path, sessions);
        } else if (fs::exists(path)) {
            sessions.insert(path.lexically_normal());
        } else {
            throw InputError(path.string() + ": there is no such file or folder.");
        }
    }
    if (sessions.empty()) {
        throw InputError(paths.front().string() +
                         ": there is no session (*.kerf.json) in this folder.");
    }
    return {sessions.begin(), sessions.end()};
}

std::vector<std::string> runArguments(const fs::path& session, const fs::path& results) {
    return {"replay",   session.string(), "--out",       results.string(),
            "--hashes", "--pieces",       "--keep-going"};
}

TestResult judgeRun(const fs::path& session, const fs::path& results, const ChildOutcome& outcome,
                    bool update) {
    TestResult result{nameOfTest(session), session, {}, outcome.seconds, {}, results};
    try {
        if (outcome.exitCode == kDone || outcome.exitCode == kCheckFailed) {
            judgeResults(result, update);
        } else {
            const bool unreadable = outcome.exitCode == kInputError;
            fail(result, unreadable ? TestStatus::unreadable : TestStatus::failed, "run",
                 "The replay did not finish: " + sentenceAbout(outcome));
        }
    } catch (const InputError& error) {
        fail(result, TestStatus::unreadable, "expectation", error.what());
    }
    return result;
}

}  // namespace kerf::app
