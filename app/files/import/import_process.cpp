#include "app/files/import/import_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "app/files/import/import_protocol.h"
#include "app/files/io/descriptor.h"
#include "app/files/io/errors.h"
#include "app/files/jobs/process_limits.h"

namespace kerf::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxLog = 64 * 1024;
constexpr std::chrono::milliseconds kCancelPoll{50};

/// This process's environment with the limits added.
class ChildEnvironment {
  public:
    explicit ChildEnvironment(const ImportLimits& limits) {
        for (char** entry = environ; *entry != nullptr; ++entry) {
            lines_.emplace_back(*entry);
        }
        lines_.push_back(std::string(kCpuVariable) + "=" + std::to_string(limits.cpuSeconds));
        lines_.push_back(std::string(kMemoryVariable) + "=" + std::to_string(limits.addressSpace));
        for (std::string& line : lines_) {
            pointers_.push_back(line.data());
        }
        pointers_.push_back(nullptr);
    }
    char** get() { return pointers_.data(); }

  private:
    std::vector<std::string> lines_;
    std::vector<char*> pointers_;
};

pid_t spawnReader(std::vector<std::string> command, const ImportLimits& limits, const Pipe& answer,
                  const Pipe& log) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, answer.write.get(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, log.write.get(), STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);

    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (std::string& word : command) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    ChildEnvironment environment(limits);
    pid_t child = 0;
    const int error = posix_spawn(&child, arguments.front(), &actions, nullptr, arguments.data(),
                                  environment.get());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        throw InputError("the program " + command.front() + " can't be started (" +
                         std::strerror(error) + "); rebuild Kerf");
    }
    return child;
}

/// Reads what is there into `bytes`, up to `limit`; closes at the end of the stream.
void drain(Descriptor& from, std::string& bytes, std::size_t limit) {
    std::array<char, 65536> block;
    const ssize_t count = ::read(from.get(), block.data(), block.size());
    if (count > 0) {
        bytes.append(block.data(), std::min<std::size_t>(count, limit - bytes.size()));
    } else if (count == 0 || errno != EINTR) {
        from.close();
    }
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
    while (answer.read.get() >= 0 || log.read.get() >= 0) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        outcome.tooSlow = left.count() <= 0;
        outcome.tooLong = outcome.answer.size() > kMaxImportAnswer;
        if (outcome.tooSlow || outcome.tooLong || isCancelled(progress)) {
            return false;
        }
        std::array<pollfd, 2> waiting{
            {{answer.read.get(), POLLIN, 0}, {log.read.get(), POLLIN, 0}}};
        const auto pause = progress != nullptr ? std::min(left, kCancelPoll) : left;
        ::poll(waiting.data(), waiting.size(), static_cast<int>(pause.count()));
        if (waiting[0].revents != 0) {
            drain(answer.read, outcome.answer, kMaxImportAnswer + 1);
        }
        if (!headIsTold && outcome.answer.size() >= kImportHeadBytes) {
            headIsTold = true;
            followers.onHead(std::string_view(outcome.answer).substr(0, kImportHeadBytes));
        }
        if (waiting[1].revents != 0) {
            drain(log.read, outcome.log, kMaxLog);
        }
    }
    return true;
}

void waitFor(pid_t child, ImportOutcome& outcome) {
    static_cast<ChildEnd&>(outcome) = waitForChild(child);
    outcome.tooSlow = outcome.tooSlow || outcome.signal == SIGXCPU;
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
    const pid_t child = spawnReader(command, limits, answer, log);
    answer.write.close();
    log.write.close();
    ImportOutcome outcome;
    try {
        if (!collect(answer, log, deadline, {progress, onHead}, outcome)) {
            ::kill(child, SIGKILL);
        }
    } catch (...) {
        ::kill(child, SIGKILL);
        waitFor(child, outcome);
        throw;
    }
    waitFor(child, outcome);
    if (isCancelled(progress)) {
        throw WorkCancelled();
    }
    return outcome;
}

}  // namespace kerf::app
