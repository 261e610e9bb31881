#include "app/files/import/import_process.h"

#include <chrono>
#include <csignal>
#include <system_error>

#include "app/files/import/import_answer.h"
#include "app/files/io/errors.h"
#include "app/files/io/system_file.h"
#include "app/files/jobs/process_limits.h"

namespace kerf::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxLog = 64 * 1024;
constexpr std::chrono::milliseconds kCancelPoll{50};

ChildProcess startReader(const std::vector<std::string>& command, const ImportLimits& limits,
                         const Pipe& answer, const Pipe& log) {
    try {
        return ChildProcess(
            {.words = command,
             .output = answer.write.get(),
             .log = log.write.get(),
             .variables = {
                 std::string(kCpuVariable) + "=" + std::to_string(limits.cpuSeconds),
                 std::string(kMemoryVariable) + "=" + std::to_string(limits.addressSpace)}});
    } catch (const std::system_error& error) {
        throw InputError("the program " + command.front() + " can't be started (" +
                         error.code().message() + "); rebuild Kerf");
    }
}

/// Keeps the first bytes of a stream.
BlockReader keepBeginning(std::string& bytes, std::size_t limit) {
    return [&bytes, limit](std::string_view block) {
        bytes.append(block.substr(0, limit - bytes.size()));
    };
}

bool isCancelled(const WorkProgress* progress) {
    return progress != nullptr && progress->cancelled();
}

/// Who follows a reading.
struct Followers {
    const WorkProgress* progress;
    const ImportHeadListener& onHead;
};

/// Collects both streams until they end. False where the deadline passes, the answer grows past
/// its limit, or nobody wants it any more.
bool collect(Pipe& answer, Pipe& log, Clock::time_point deadline, const Followers& followers,
             ImportOutcome& outcome) {
    const WorkProgress* const progress = followers.progress;
    bool headIsTold = followers.onHead == nullptr;
    const auto patience = [&] {
        if (!headIsTold && outcome.answer.size() >= kImportHeadBytes) {
            headIsTold = true;
            followers.onHead(std::string_view(outcome.answer).substr(0, kImportHeadBytes));
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        outcome.tooSlow = left.count() <= 0;
        outcome.tooLong = outcome.answer.size() > kMaxImportAnswer;
        const auto pause = progress != nullptr ? std::min(left, kCancelPoll) : left;
        return outcome.tooSlow || outcome.tooLong || isCancelled(progress)
                   ? -1
                   : static_cast<int>(pause.count());
    };
    return readStreams(answer, keepBeginning(outcome.answer, kMaxImportAnswer + 1), log,
                       keepBeginning(outcome.log, kMaxLog), patience);
}

}  // namespace

ImportOutcome runImportProcess(const std::filesystem::path& program,
                               const std::filesystem::path& file, const ImportLimits& limits,
                               const WorkProgress* progress, const ImportHeadListener& onHead) {
    return runLimitedProcess({program.string(), "import-worker", "--", file.string()}, limits,
                             progress, onHead);
}

ImportOutcome runLimitedProcess(const std::vector<std::string>& command, const ImportLimits& limits,
                                const WorkProgress* progress, const ImportHeadListener& onHead) {
    const auto deadline = Clock::now() + std::chrono::seconds(limits.wallSeconds);
    Pipe answer;
    Pipe log;
    ChildProcess child = startReader(command, limits, answer, log);
    answer.write.close();
    log.write.close();
    ImportOutcome outcome;
    if (!collect(answer, log, deadline, {progress, onHead}, outcome)) {
        child.kill();
    }
    static_cast<ChildEnd&>(outcome) = child.wait();
    outcome.tooSlow = outcome.tooSlow || outcome.signal == SIGXCPU;
    if (isCancelled(progress)) {
        throw WorkCancelled();
    }
    return outcome;
}

}  // namespace kerf::app
