#include "app/study/study_run.h"

#include <fcntl.h>

#include <cerrno>
#include <cstring>

#include "app/files/export/export.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/jobs/child_runs.h"
#include "app/session/session.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

constexpr int kSignalled = 128;

/// Where a run writes until it is complete.
fs::path unfinishedFolder(const fs::path& out, std::size_t number) {
    return out / ("." + std::to_string(number) + ".part");
}

void removeFolder(const fs::path& folder) {
    std::error_code error;
    fs::remove_all(folder, error);
    if (error) {
        throw OutputError(folder.string() + ": an older result could not be removed (" +
                          error.message() + ").");
    }
}

/// Whether a run of the session may have written a file of this name.
bool isResult(const Session& session, const fs::path& name) {
    if (name == kRecordFile || std::ranges::find(kReplayFiles, name) != kReplayFiles.end()) {
        return true;
    }
    return std::ranges::any_of(session.events, [&](const SessionEvent& event) {
        const std::string* const file = fileOf(event.action);
        return file != nullptr && (name == *file || isPieceFile(name, *file));
    });
}

/// Whether nothing lies there but what a run may have left.
bool holdsOnlyResults(const fs::path& folder, const Session& session) {
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
        if (!entry.is_directory(error) &&
            !isResult(session, entry.path().lexically_relative(folder))) {
            return false;
        }
    }
    return !error;
}

/// What is no run of a sweep was put there by somebody else, who may want to keep it.
void requireReplaceable(const fs::path& folder, const fs::path& session) {
    std::error_code error;
    if (!fs::exists(folder) || fs::is_empty(folder, error) || readRecord(folder)) {
        return;
    }
    if (!fs::exists(folder / kRecordFile) || !holdsOnlyResults(folder, readSession(session))) {
        throw OutputError(folder.string() +
                          ": there is something else than a run of a sweep; choose another --out.");
    }
}

std::vector<std::string> replayArguments(const Study& study, const StudyRun& run,
                                         const fs::path& folder) {
    std::vector<std::string> words{"replay", study.sessionOf(run).file.string(), "--out",
                                   folder.string(), "--no-hash-checks"};
    for (const Setting& setting : run.settings) {
        words.insert(words.end(), {"--set", setting.name + "=" + setting.value});
    }
    return words;
}

ChildOutcome replay(const Study& study, const StudyRun& run, const fs::path& folder) {
    ChildOutcome outcome;
    runChildren({replayArguments(study, run, folder)}, 1,
                [&](std::size_t, const ChildOutcome& end) { outcome = end; });
    return outcome;
}

RunRecord recordOf(const RunIdentity& identity, const ChildOutcome& outcome,
                   const fs::path& folder) {
    const int exitCode = outcome.signal != 0 ? kSignalled + outcome.signal : outcome.exitCode;
    return {identity, exitCode, exitCode == 0 ? "" : sentenceAbout(outcome), digestsOf(folder)};
}

void moveFolder(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) {
        throw OutputError(to.string() + ": this folder could not be made (" + error.message() +
                          ").");
    }
}

/// Runs it and lets its folder appear.
RunEnd replaceRun(const Study& study, std::size_t number, const fs::path& out) {
    const fs::path folder = folderOfRun(out, number);
    const fs::path unfinished = unfinishedFolder(out, number);
    const StudyRun& run = study.runs[number];
    requireReplaceable(folder, study.sessionOf(run).file);
    removeFolder(unfinished);
    const ChildOutcome outcome = replay(study, run, unfinished);
    if (outcome.exitCode == kExitNoOpenGl) {
        return {.record = {}, .log = outcome.log, .noOpenGl = true};
    }
    RunEnd end{.record = recordOf(identityOf(study, run), outcome, unfinished), .log = outcome.log};
    OutputFolder(unfinished).write(kRecordFile, formatRecord(end.record));
    removeFolder(folder);
    moveFolder(unfinished, folder);
    return end;
}

}  // namespace

RunEnd performRun(const Study& study, std::size_t number, const fs::path& out) {
    OutputFolder folder(out);
    const RunLock lock(out, number);
    const RunState state = stateOfRun(study, number, out);
    if (state.done()) {
        return {.record = *state.record, .wasDone = true, .log = {}};
    }
    return replaceRun(study, number, out);
}

namespace {

constexpr const char* kLockFile = ".lock";

/// Children inherit it: the run stays held until the last one that may write has ended.
int openLockFile(const std::filesystem::path& file) {
    const int opened = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW, 0666);
    if (opened < 0) {
        throw OutputError(file.string() + ": this file can't be written (" + std::strerror(errno) +
                          ").");
    }
    return opened;
}

/// A byte of the file for each run.
struct flock byteOf(std::size_t number, short type) {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = static_cast<off_t>(number);
    lock.l_len = 1;
    return lock;
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& out, std::size_t number)
    : file_(openLockFile(out / kLockFile)), number_(number) {
    struct flock lock = byteOf(number, F_WRLCK);
    while (::fcntl(file_.get(), F_OFD_SETLKW, &lock) < 0 && errno == EINTR) {
    }
}

void RunLock::requireFile(const std::filesystem::path& out) {
    const Descriptor file(openLockFile(out / kLockFile));
}

RunLock::~RunLock() {
    struct flock lock = byteOf(number_, F_UNLCK);
    ::fcntl(file_.get(), F_OFD_SETLK, &lock);
}

}  // namespace kerf::app
