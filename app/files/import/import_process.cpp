#include "app/files/import/import_process.h"

#include <chrono>
#include <csignal>
#include <system_error>

#include "app/files/io/errors.h"
#include "app/files/io/system_file.h"
#include "app/files/jobs/process_limits.h"
#include "sim/base/text.h"

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
                         error.code().message() + "); install Kerf again");
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

/// Follows a program that reads a file, while it runs.
class ReaderWatch {
  public:
    ReaderWatch(const ImportLimits& limits, WorkProgress* progress)
        : progress_(progress), deadline_(Clock::now() + std::chrono::seconds(limits.wallSeconds)) {}

    /// Collects both streams until they end, the deadline passes, the answer grows past its limit,
    /// or nobody wants it any more.
    void collect(Pipe& answer, Pipe& log) {
        readStreams(
            answer, keepBeginning(end.answer, kMaxImportAnswer + 1), log,
            [this](std::string_view block) { follow(block); }, [this] { return patience(); });
    }

    ImportEnd end;

  private:
    int patience() {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now());
        end.tooSlow = left.count() <= 0;
        end.tooLong = end.answer.size() > kMaxImportAnswer;
        const auto pause = progress_ != nullptr ? std::min(left, kCancelPoll) : left;
        return end.tooSlow || end.tooLong || isCancelled(progress_)
                   ? -1
                   : static_cast<int>(pause.count());
    }

    /// Takes lines apart into stages and the log.
    void follow(std::string_view block) {
        for (const char c : block) {
            line_ += c;
            if (c == '\n' || line_.size() > kMaxLog) {
                takeLine();
            }
        }
    }

    void takeLine() {
        const std::string line = std::exchange(line_, "");
        if (line.front() != kStageMark) {
            end.log.append(line, 0, kMaxLog - std::min(kMaxLog, end.log.size()));
            return;
        }
        if (end.stage.empty()) {
            deadline_ = Clock::now() + std::chrono::seconds(kMendingWallSeconds);
        }
        end.stage = printable(line.substr(1, line.size() - 2));
        if (progress_ != nullptr && !progress_->cancelled()) {
            progress_->enter(end.stage);
        }
    }

    WorkProgress* progress_;
    Clock::time_point deadline_;
    std::string line_;  ///< of the log, as far as it has arrived
};

}  // namespace

ImportEnd runImportProcess(const std::vector<std::string>& command, const ImportLimits& limits,
                           WorkProgress* progress) {
    Pipe answer;
    Pipe log;
    ReaderWatch reading(limits, progress);
    ChildProcess child = startReader(command, limits, answer, log);
    answer.write.close();
    log.write.close();
    reading.collect(answer, log);
    child.kill();  // one that has closed its streams and goes on has no more to say, either
    ImportEnd end = std::move(reading.end);
    static_cast<ChildEnd&>(end) = child.wait();
    end.tooSlow = end.tooSlow || end.signal == SIGXCPU;
    if (isCancelled(progress)) {
        throw WorkCancelled();
    }
    return end;
}

}  // namespace kerf::app
