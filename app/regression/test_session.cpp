#include "app/regression/test_session.h"

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/session/session.h"
#include "gpu/context.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

bool isSession(const fs::path& file) {
    return file.filename().string().ends_with(kSessionEnding);
}

/// Sessions by the file that they are, whichever way leads there.
using FoundSessions = std::map<fs::path, fs::path>;

void add(const fs::path& session, FoundSessions& sessions) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(session, error);
    sessions.emplace(error ? fs::absolute(session) : canonical, session.lexically_normal());
}

bool isSearched(const fs::path& folder) {
    return !folder.filename().string().starts_with('.') && folder.extension() != ".expected";
}

/// What can't be read is found all the same: a test that nobody runs holds nothing.
void searchFolder(const fs::path& folder, FoundSessions& sessions) {
    std::error_code error;
    std::error_code unknown;
    for (auto entry = fs::directory_iterator(folder, error); entry != fs::directory_iterator();
         entry.increment(error)) {
        if (!entry->is_directory(unknown)) {
            if (isSession(entry->path())) {
                add(entry->path(), sessions);
            }
        } else if (!entry->is_symlink(unknown) && isSearched(entry->path())) {
            searchFolder(entry->path(), sessions);
        }
    }
    if (error) {
        add(folder, sessions);
    }
}

/// Those at one path.
FoundSessions sessionsAt(const fs::path& path) {
    FoundSessions sessions;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found && !fs::is_symlink(path, error)) {
        throw InputError(path.string() + ": there is no such file or folder; check the name.");
    }
    if (!fs::is_directory(status)) {
        add(path, sessions);
    } else {
        searchFolder(path, sessions);
    }
    if (sessions.empty()) {
        throw InputError(path.string() + ": there is no session (*.kerf.json) in this folder.");
    }
    return sessions;
}

std::string nameOfTest(const fs::path& session) {
    std::string name = session.generic_string();
    if (name.ends_with(kSessionEnding)) {
        name.resize(name.size() - kSessionEnding.size());
    }
    return name;
}

TestResult resultOf(const fs::path& session) {
    TestResult result;
    result.name = nameOfTest(session);
    result.session = session;
    return result;
}

void fail(TestResult& result, TestStatus status, const std::string& part,
          const std::string& sentence) {
    result.status = status;
    result.judgement.findings.push_back({part, -1, sentence});
}

/// What goes wrong with the files of one test is told of that test.
void judgeSafely(TestResult& result, const std::function<void()>& work) {
    try {
        work();
    } catch (const InputError& error) {
        fail(result, TestStatus::unreadable, "expectation", error.what());
    } catch (const OutputError& error) {
        fail(result, TestStatus::unwritable, "output", error.what());
    } catch (const fs::filesystem_error& error) {
        fail(result, TestStatus::unreadable, "expectation",
             error.path1().string() + ": " + error.code().message() + ".");
    }
}

/// What a run broke of its own session is no expectation.
void refuse(TestResult& result, const RunResults& run, bool isNew) {
    result.status = TestStatus::failed;
    for (const std::string& failure : run.failures) {
        if (isNew) {
            result.judgement.findings.push_back(findingOfCheck(failure));
        }
    }
    result.notes.push_back("So nothing was written: mend the session's checks first.");
}

/// Hashes in the session's own checks, which `kerf replay` goes by and this test does not.
void noteOldChecks(TestResult& result, const Session& session, const RunResults& run) {
    for (const SessionEvent& event : session.events) {
        const auto* check = std::get_if<CheckEvent>(&event.action);
        const bool known =
            check != nullptr && check->hash && event.step > 0 && event.step <= run.hashes.steps();
        if (known && run.hashes.stateHash(event.step - 1) != *check->hash) {
            result.notes.push_back("kerf replay will fail: the session's own check before step " +
                                   std::to_string(event.step) +
                                   " has another state hash; remove such checks, they are not "
                                   "needed here.");
            return;
        }
    }
}

/// An expectation that is there but can't be read counts as there.
bool hasExpectation(const fs::path& session) {
    std::error_code error;
    return fs::status(expectationFolder(session) / kExpectedFile, error).type() !=
           fs::file_type::not_found;
}

void judgeBeforeRun(TestResult& result, bool update) {
    const fs::path expected = expectationFolder(result.session) / kExpectedFile;
    if (fs::is_directory(result.session)) {
        throw InputError(result.session.string() +
                         ": this folder can't be searched; check its permissions.");
    }
    if (hasExpectation(result.session)) {
        readExpectation(expected);
    } else if (!update) {
        readSession(result.session);
        fail(result, TestStatus::failed, "expectation",
             "There is no " + expected.string() + "; make it with kerf test --update " +
                 asArgument(result.session) + ".");
    }
}

void renew(TestResult& result, const Session& session, const RunResults& run, bool isNew) {
    if (!run.failures.empty()) {
        refuse(result, run, isNew);
        return;
    }
    if (isNew || !result.judgement.holds() || result.judgement.otherDriver) {
        writeExpectation(expectationFolder(result.session), run);
        result.status = isNew ? TestStatus::made : TestStatus::renewed;
        noteOldChecks(result, session, run);
    }
    if (isNew && run.pictures.empty()) {
        result.notes.push_back("It has no picture; a screenshot event in the session makes one.");
    }
}

/// An expectation whose files are damaged doesn't hold where it is to be made anew.
Judgement judgeAgainst(const fs::path& expected, const RunResults& run, const fs::path& differences,
                       bool update) {
    try {
        return judge(expected, run, differences);
    } catch (const InputError& error) {
        if (!update) {
            throw;
        }
        Judgement judgement;
        judgement.findings.push_back({"expectation", -1, error.what()});
        return judgement;
    }
}

void judgeResults(TestResult& result, bool update) {
    const Session session = readSession(result.session);
    const RunResults run = readResults(result.results, session);
    result.driver = run.driver;
    result.notes = run.messages;
    const fs::path expected = expectationFolder(result.session);
    const bool isNew = !hasExpectation(result.session);
    if (!isNew) {
        result.judgement =
            judgeAgainst(expected, run, OutputFolder(result.results).pathOf("diff"), update);
    }
    result.status = result.judgement.holds() ? TestStatus::passed : TestStatus::failed;
    if (update) {
        renew(result, session, run, isNew);
    }
}

/// How to make the session of a failed test small. Where the run broke nothing of its own, only
/// another build can tell what is right.
void noteReduction(TestResult& result, bool brokeItself) {
    const std::string reduce =
        "To make it small: kerf reduce " + asArgument(result.session) + " --out reduced -- ";
    result.notes.push_back(
        brokeItself ? reduce + "kerf replay {} --no-hash-checks --out reduced/run"
                    : reduce +
                          "sh -c 'OLD replay {} --hashes --out reduced/old && kerf replay {} "
                          "--verify reduced/old/hashes.csv --out reduced/new', where OLD is "
                          "the kerf of a build that passes");
}

}  // namespace

std::vector<fs::path> findSessions(const std::vector<fs::path>& paths) {
    FoundSessions sessions;
    for (const fs::path& path : paths) {
        sessions.merge(sessionsAt(path));
    }
    std::vector<fs::path> found;
    for (const auto& [canonical, session] : sessions) {
        found.push_back(session);
    }
    std::ranges::sort(found);
    return found;
}

std::vector<std::string> runArguments(const fs::path& session, const fs::path& results,
                                      bool hashChecks) {
    std::vector<std::string> arguments{
        "replay",   asArgument(session), "--out",       asArgument(results),
        "--hashes", "--pieces",          "--keep-going"};
    if (!hashChecks) {
        arguments.emplace_back("--no-hash-checks");
    }
    return arguments;
}

std::optional<TestResult> judgeWithoutRun(const fs::path& session, bool update) {
    TestResult result = resultOf(session);
    judgeSafely(result, [&] { judgeBeforeRun(result, update); });
    return result.judgement.holds() ? std::nullopt : std::optional(std::move(result));
}

TestResult resultOfNoRun(const fs::path& session) {
    TestResult result = resultOf(session);
    fail(result, TestStatus::notRun, "run", "It was not run: the tests were stopped before.");
    return result;
}

TestResult judgeRun(const fs::path& session, const fs::path& results, const ChildOutcome& outcome,
                    bool update) {
    TestResult result = resultOf(session);
    result.seconds = outcome.seconds;
    result.results = results;
    if (outcome.exitCode == kExitNoOpenGl) {
        throw gpu::ContextError(lastWords(outcome));
    }
    judgeSafely(result, [&] {
        if (outcome.exitCode == kExitDone || outcome.exitCode == kExitCheckFailed) {
            judgeResults(result, update);
        } else if (outcome.exitCode == kExitInput) {
            fail(result, TestStatus::unreadable, "session", lastWords(outcome));
        } else if (outcome.exitCode == kExitLimit) {
            fail(result, TestStatus::unwritable, "run", lastWords(outcome));
        } else {
            fail(result, TestStatus::failed, "run",
                 "The replay did not finish: " + sentenceAbout(outcome));
        }
    });
    if (result.status == TestStatus::failed) {
        noteReduction(result, outcome.exitCode != kExitDone);
    }
    return result;
}

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

namespace {

constexpr std::uintmax_t kMaxKeptBytes = 1u << 30;

std::optional<Expectation> earlierExpectation(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kExpectedFile;
    return std::filesystem::exists(file) ? std::optional(readExpectation(file)) : std::nullopt;
}

const ExpectedPicture* findPicture(const Expectation& expectation, const std::string& file) {
    const auto found = std::ranges::find(expectation.pictures, file, &ExpectedPicture::file);
    return found == expectation.pictures.end() ? nullptr : &*found;
}

/// With what a person set in the earlier one.
Expectation expectationOf(const RunResults& results, const Expectation& earlier) {
    Expectation expectation{
        KERF_VERSION,      results.driver,     static_cast<int>(results.trace.size()),
        results.stateHash, earlier.tolerances, {}};
    for (const TakenPicture& picture : results.pictures) {
        const ExpectedPicture* before = findPicture(earlier, picture.file);
        expectation.pictures.push_back(before != nullptr ? *before
                                                         : ExpectedPicture{picture.file, {}, {}});
    }
    return expectation;
}

void copyFile(const RunResults& results, const std::string& name, OutputFolder& folder) {
    folder.write(name, readInputFile(results.folder / name, kMaxKeptBytes));
}

}  // namespace

void writeExpectation(const std::filesystem::path& expectationFolder, const RunResults& results) {
    if (std::filesystem::is_symlink(expectationFolder)) {
        throw OutputError(expectationFolder.string() +
                          ": this is a link, through which nothing is written; put the folder "
                          "itself there.");
    }
    const Expectation earlier = earlierExpectation(expectationFolder).value_or(Expectation{});
    const Expectation expectation = expectationOf(results, earlier);
    OutputFolder folder(expectationFolder);
    for (const std::string& file : unlistedPictures(expectationFolder, expectation)) {
        folder.remove(file);
    }
    for (const ExpectedPicture& picture : expectation.pictures) {
        copyFile(results, picture.file, folder);
    }
    copyFile(results, kHashesFile, folder);
    folder.write(kTraceFile, formatTrace(results.trace));
    folder.write(kPieceBoxesFile, formatPieces(thinnedOut(results.pieces)));
    folder.write(kExpectedFile, formatExpectation(expectation));
}

}  // namespace kerf::app
