#include "app/files/jobs/child_runs.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "app/files/io/file_io.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

namespace {

constexpr std::size_t kKeptLog = 16 * 1024;
constexpr int kCancelPoll = 50;  // [ms]

/// Keeps the last bytes of a log.
BlockReader keepEnd(std::string& log) {
    return [&log](std::string_view block) {
        log.append(block);
        log.erase(0, log.size() - std::min(log.size(), kKeptLog));
    };
}

/// Starts this program.
ChildProcess startChild(const std::vector<std::string>& arguments, int output, int log) {
    std::vector<std::string> words{kerfProgram().string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    try {
        return ChildProcess(
            {.words = std::move(words), .output = output, .log = log, .inheritsFiles = true});
    } catch (const std::system_error& error) {
        throw OutputError("Another process can't be started (" + error.code().message() + ").");
    }
}

/// Shares out runs among threads. The first error stops it.
class Crew {
  public:
    Crew(const std::vector<std::vector<std::string>>& runs,
         const std::function<void(std::size_t, const ChildOutcome&)>& done)
        : runs_(runs), done_(done) {}

    void work() {
        for (std::size_t run = next_++; run < runs_.size() && !stopped(); run = next_++) {
            try {
                const ChildOutcome outcome = runChild(runs_[run], WorkProgress(), nullptr);
                const std::lock_guard lock(mutex_);
                // Ctrl+C reaches the children as well.
                if (outcome.signal == 0 || !Interruption::requested()) {
                    done_(run, outcome);
                }
            } catch (...) {
                const std::lock_guard lock(mutex_);
                error_ = error_ ? error_ : std::current_exception();
                failed_ = true;
            }
        }
    }
    void rethrow() const {
        if (error_) {
            std::rethrow_exception(error_);
        }
    }

  private:
    bool stopped() const { return failed_ || Interruption::requested(); }

    const std::vector<std::vector<std::string>>& runs_;
    const std::function<void(std::size_t, const ChildOutcome&)>& done_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    std::exception_ptr error_;
};

/// The last line that says something.
std::string lastLine(std::string text) {
    text.erase(text.find_last_not_of(" \r\n") + 1);
    return text.substr(text.rfind('\n') + 1);
}

}  // namespace

void runChildren(const std::vector<std::vector<std::string>>& runs, int jobs,
                 const std::function<void(std::size_t, const ChildOutcome&)>& done) {
    Crew crew(runs, done);
    std::vector<std::thread> threads;
    const auto count = std::min<std::size_t>(runs.size(), static_cast<std::size_t>(jobs));
    for (std::size_t i = 0; i < count; ++i) {
        threads.emplace_back([&crew] { crew.work(); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    crew.rethrow();
}

std::string asArgument(const std::filesystem::path& path) {
    return path.string().starts_with('-') ? "./" + path.string() : path.string();
}

std::string lastWords(const ChildOutcome& outcome) {
    constexpr std::string_view kName = "kerf: ";
    const std::string said = lastLine(outcome.log);
    return said.starts_with(kName) ? said.substr(kName.size()) : said;
}

ChildOutcome runChild(const std::vector<std::string>& arguments, const WorkProgress& progress,
                      const std::function<void(int count)>& lines) {
    const Stopwatch watch;
    Pipe output;
    Pipe log;
    ChildProcess child = startChild(arguments, lines ? output.write.get() : -1, log.write.get());
    output.write.close();
    log.write.close();
    ChildOutcome outcome;
    int count = 0;
    const BlockReader countLines = [&](std::string_view block) {
        count += static_cast<int>(std::ranges::count(block, '\n'));
        lines(count);
    };
    const auto unlessCancelled = [&] {
        return progress.cancelled() ? throw WorkCancelled() : kCancelPoll;
    };
    readStreams(output, countLines, log, keepEnd(outcome.log), unlessCancelled);
    static_cast<ChildEnd&>(outcome) = child.wait();
    outcome.seconds = watch.seconds();
    return outcome;
}

std::string sentenceAbout(const ChildOutcome& outcome) {
    const std::string end = outcome.signal != 0
                                ? "it was ended by signal " + std::to_string(outcome.signal)
                                : "it ended with exit code " + std::to_string(outcome.exitCode);
    const std::string said = lastWords(outcome);
    return said.empty() ? end : end + ": " + said;
}

std::string sentenceAbout(const ChildOutcome& outcome, const std::filesystem::path& folder) {
    const std::string inFolder = folder.string() + "/";
    std::string sentence = sentenceAbout(outcome);
    for (std::size_t at = 0; (at = sentence.find(inFolder, at)) != std::string::npos;) {
        sentence.erase(at, inFolder.size());
    }
    return sentence;
}

}  // namespace kerf::app
