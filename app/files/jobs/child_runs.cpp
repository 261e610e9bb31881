#include "app/files/jobs/child_runs.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

#include "app/files/io/descriptor.h"
#include "app/files/io/file_io.h"
#include "app/files/jobs/interruption.h"
#include "app/files/jobs/own_programs.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

namespace {

constexpr std::size_t kKeptLog = 16 * 1024;
constexpr int kCancelPoll = 50;  // [ms]

/// The words of a command line as the system takes them.
class ArgumentList {
  public:
    explicit ArgumentList(std::vector<std::string> words) : words_(std::move(words)) {
        for (std::string& word : words_) {
            pointers_.push_back(word.data());
        }
        pointers_.push_back(nullptr);
    }
    char* const* get() const { return pointers_.data(); }

  private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

/// In the child, where nothing but system calls is safe: its parent has threads.
[[noreturn]] void becomeProgram(const char* program, const ArgumentList& arguments, int output,
                                int log, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = ::open("/dev/null", O_RDWR);
    const bool ready = ::getppid() == parent && ::dup2(nothing, STDIN_FILENO) >= 0 &&
                       ::dup2(output >= 0 ? output : nothing, STDOUT_FILENO) >= 0 &&
                       ::dup2(log, STDERR_FILENO) >= 0;
    if (ready) {
        ::execv(program, arguments.get());
    }
    ::_exit(127);
}

/// What a child writes, block by block.
using Reader = std::function<void(std::string_view block)>;

/// Hands on what is there; closes at the end of the stream.
void readSome(Descriptor& from, const Reader& reader) {
    std::array<char, 4096> block;
    const ssize_t count = ::read(from.get(), block.data(), block.size());
    if (count > 0) {
        reader({block.data(), static_cast<std::size_t>(count)});
    } else if (count == 0 || errno != EINTR) {
        from.close();
    }
}

/// Keeps the last bytes of a log.
Reader keepEnd(std::string& log) {
    return [&log](std::string_view block) {
        log.append(block);
        log.erase(0, log.size() - std::min(log.size(), kKeptLog));
    };
}

/// Starts this program, which writes to `log`, and to `output` unless that is -1.
pid_t startChild(const std::vector<std::string>& arguments, int output, int log) {
    const std::string program = importProgram().string();
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const ArgumentList list(std::move(words));
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child == 0) {
        becomeProgram(program.c_str(), list, output, log, parent);
    }
    if (child < 0) {
        throw OutputError(std::string("Another process can't be started (") + std::strerror(errno) +
                          ").");
    }
    return child;
}

/// A child that is gone at the end of the scope, whatever happens.
class Child {
  public:
    Child(const std::vector<std::string>& arguments, int output, int log)
        : id_(startChild(arguments, output, log)) {}
    ~Child() {
        if (id_ != 0) {
            ::kill(id_, SIGKILL);
            waitForChild(id_);
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ChildEnd wait() { return waitForChild(std::exchange(id_, 0)); }

  private:
    pid_t id_;
};

ChildOutcome runChild(const std::vector<std::string>& arguments) {
    const Stopwatch watch;
    Pipe log;
    Child child(arguments, -1, log.write.get());
    log.write.close();
    ChildOutcome outcome;
    while (log.read.get() >= 0) {
        readSome(log.read, keepEnd(outcome.log));
    }
    static_cast<ChildEnd&>(outcome) = child.wait();
    outcome.seconds = watch.seconds();
    return outcome;
}

/// Reads both streams until they end.
void readUnlessCancelled(Pipe& output, const Reader& ofOutput, Pipe& log, const Reader& ofLog,
                         const WorkProgress& progress) {
    while (output.read.get() >= 0 || log.read.get() >= 0) {
        if (progress.cancelled()) {
            throw WorkCancelled();
        }
        std::array<pollfd, 2> waiting{
            {{output.read.get(), POLLIN, 0}, {log.read.get(), POLLIN, 0}}};
        ::poll(waiting.data(), waiting.size(), kCancelPoll);
        if (waiting[0].revents != 0) {
            readSome(output.read, ofOutput);
        }
        if (waiting[1].revents != 0) {
            readSome(log.read, ofLog);
        }
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
                const ChildOutcome outcome = runChild(runs_[run]);
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

ChildEnd waitForChild(int process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

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
    Child child(arguments, output.write.get(), log.write.get());
    output.write.close();
    log.write.close();
    ChildOutcome outcome;
    int count = 0;
    const Reader countLines = [&](std::string_view block) {
        count += static_cast<int>(std::ranges::count(block, '\n'));
        lines(count);
    };
    readUnlessCancelled(output, countLines, log, keepEnd(outcome.log), progress);
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
