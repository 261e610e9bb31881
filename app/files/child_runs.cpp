#include "app/files/child_runs.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

#include "app/files/descriptor.h"
#include "app/files/file_io.h"
#include "app/files/import_process.h"
#include "app/files/interruption.h"
#include "sim/base/stopwatch.h"

namespace kerf::app {

namespace {

constexpr std::size_t kKeptLog = 16 * 1024;

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
[[noreturn]] void becomeProgram(const char* program, const ArgumentList& arguments, int log,
                                pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = ::open("/dev/null", O_RDWR);
    const bool ready = ::getppid() == parent && ::dup2(nothing, STDIN_FILENO) >= 0 &&
                       ::dup2(nothing, STDOUT_FILENO) >= 0 && ::dup2(log, STDERR_FILENO) >= 0;
    if (ready) {
        ::execv(program, arguments.get());
    }
    ::_exit(127);
}

/// Reads until the child closes its end, keeping the last bytes.
std::string readEnd(const Descriptor& from) {
    std::string log;
    char block[4096];
    for (;;) {
        const ssize_t count = ::read(from.get(), block, sizeof block);
        if (count == 0 || (count < 0 && errno != EINTR)) {
            return log;
        }
        log.append(block, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        log.erase(0, log.size() - std::min(log.size(), kKeptLog));
    }
}

void waitFor(pid_t child, ChildOutcome& outcome) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status)) {
        outcome.exitCode = WEXITSTATUS(status);
    } else if (WIFSIGNALED(status)) {
        outcome.signal = WTERMSIG(status);
    }
}

ChildOutcome runChild(const std::vector<std::string>& arguments) {
    const Stopwatch watch;
    const std::string program = kerfProgram().string();
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const ArgumentList list(std::move(words));
    Pipe log;
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child == 0) {
        becomeProgram(program.c_str(), list, log.write.get(), parent);
    }
    if (child < 0) {
        throw OutputError(std::string("Another process can't be started (") + std::strerror(errno) +
                          ").");
    }
    log.write.close();
    ChildOutcome outcome;
    outcome.log = readEnd(log.read);
    waitFor(child, outcome);
    outcome.seconds = watch.milliseconds() / 1000;
    return outcome;
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

std::filesystem::path kerfProgram() {
    return importProgram();
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

std::string lastWords(const ChildOutcome& outcome) {
    constexpr std::string_view kName = "kerf: ";
    const std::string said = lastLine(outcome.log);
    return said.starts_with(kName) ? said.substr(kName.size()) : said;
}

std::string sentenceAbout(const ChildOutcome& outcome) {
    const std::string end = outcome.signal != 0
                                ? "it was ended by signal " + std::to_string(outcome.signal)
                                : "it ended with exit code " + std::to_string(outcome.exitCode);
    const std::string said = lastWords(outcome);
    return said.empty() ? end : end + ": " + said;
}

}  // namespace kerf::app
