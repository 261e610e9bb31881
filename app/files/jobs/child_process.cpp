#include "app/files/jobs/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "gpu/data_path.h"

namespace kerf::app {

namespace {

/// As the system takes texts: `first`, which may be null, and `more`, behind it.
std::vector<char*> pointersTo(char* const* first, const std::vector<std::string>& more) {
    std::vector<char*> pointers;
    for (; first != nullptr && *first != nullptr; ++first) {
        pointers.push_back(*first);
    }
    for (const std::string& text : more) {
        pointers.push_back(const_cast<char*>(text.c_str()));
    }
    pointers.push_back(nullptr);
    return pointers;
}

/// In the child, where nothing but system calls is safe: it has the memory of its parent, which has
/// threads. Returns why it failed.
int becomeProgram(const ChildOrder& order, char* const* words, char* const* environment,
                  pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) {
        return ESRCH;
    }
    const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    const std::array streams{order.input, order.output, order.log};
    for (int stream = 0; stream < 3; ++stream) {
        if (::dup2(streams[stream] >= 0 ? streams[stream] : nothing, stream) < 0) {
            return errno;
        }
    }
    if (!order.inheritsFiles) {
        ::closefrom(STDERR_FILENO + 1);
    }
    ::execvpe(words[0], words, environment);
    return errno;
}

/// Hands on what is there; closes at the end of the stream.
void readSome(Descriptor& from, const BlockReader& reader) {
    std::array<char, 65536> block;
    const ssize_t count = ::read(from.get(), block.data(), block.size());
    if (count > 0) {
        reader({block.data(), static_cast<std::size_t>(count)});
    } else if (count == 0 || errno != EINTR) {
        from.close();
    }
}

volatile std::sig_atomic_t interrupted = 0;

void noteSignal(int /*signal*/) {
    interrupted = 1;
}

bool thisProgramRuns = false;  // see runThisProgram

}  // namespace

ChildProcess::ChildProcess(const ChildOrder& order) {
    const std::vector<char*> words = pointersTo(nullptr, order.words);
    const std::vector<char*> environment = pointersTo(environ, order.variables);
    const pid_t parent = ::getpid();
    volatile int error = 0;  // written by the child: this thread stands until it has its own memory
    const pid_t child = ::vfork();
    if (child == 0) {
        error = becomeProgram(order, words.data(), environment.data(), parent);
        ::_exit(127);
    }
    id_ = child;
    if (child < 0) {
        throw std::system_error(errno, std::generic_category());
    }
    if (error != 0) {
        wait();
        throw std::system_error(error, std::generic_category());
    }
}

ChildProcess::~ChildProcess() {
    if (id_ != 0) {
        kill();
        wait();
    }
}

void ChildProcess::kill() const {
    ::kill(id_, SIGKILL);
}

ChildEnd ChildProcess::wait() {
    const pid_t child = std::exchange(id_, 0);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

bool readStreams(Pipe& output, const BlockReader& ofOutput, Pipe& log, const BlockReader& ofLog,
                 const std::function<int()>& patience) {
    while (output.read.get() >= 0 || log.read.get() >= 0) {
        const int wait = patience();
        if (wait < 0) {
            return false;
        }
        std::array<pollfd, 2> waiting{
            {{output.read.get(), POLLIN, 0}, {log.read.get(), POLLIN, 0}}};
        ::poll(waiting.data(), waiting.size(), wait);
        if (waiting[0].revents != 0) {
            readSome(output.read, ofOutput);
        }
        if (waiting[1].revents != 0) {
            readSome(log.read, ofLog);
        }
    }
    return true;
}

Interruption::Interruption() {
    interrupted = 0;
    struct sigaction note {};
    note.sa_handler = noteSignal;
    note.sa_flags = SA_RESTART;
    ::sigaction(SIGINT, &note, &earlierInterrupt_);
    ::sigaction(SIGTERM, &note, &earlierTerminate_);
}

Interruption::~Interruption() {
    ::sigaction(SIGINT, &earlierInterrupt_, nullptr);
    ::sigaction(SIGTERM, &earlierTerminate_, nullptr);
}

bool Interruption::requested() {
    return interrupted != 0;
}

void runThisProgram() {
    thisProgramRuns = true;
}

std::filesystem::path kerfProgram() {
    if (const char* chosen = std::getenv("KERF_EXECUTABLE"); chosen != nullptr) {
        return chosen;
    }
    return thisProgramRuns ? "/proc/self/exe" : programBeside("kerf");
}

std::filesystem::path programBeside(const std::string& name) {
    const std::filesystem::path folder = gpu::programFolder();
    const std::filesystem::path installed = folder.parent_path() / "libexec/kerf" / name;
    return std::filesystem::exists(installed) ? installed : folder / name;
}

}  // namespace kerf::app
